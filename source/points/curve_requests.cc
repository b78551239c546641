// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/parameters/accuracy_budget.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/curve_requests.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Fractions of the stall torque at which the shape of a curve is sampled first: fewer of a
     * marched motor, whose points are dear. */
    std::vector<double> shares_for_shape(const bool is_marched)
    {
      if (is_marched)
        return {0., 0.6, 0.9};
      return {0., 0.3, 0.6, 0.8, 0.9, 0.97};
    }
  } // namespace

  std::vector<PointRequest> points_along_curve(const std::vector<CurvePoint> &shape,
                                               const unsigned int n_points)
  {
    Assert(shape.size() > 1 && n_points > 1, ExcInternalError());
    // Motors operate where torque changes their speed little: a fall of the speed to zero counts
    // less than a rise of the torque to stall.
    constexpr double weight = 0.4;
    const double torque = shape.back().result.torque, speed = shape.front().result.speed / weight;
    Assert(torque != 0. && speed != 0., ExcMessage("a curve without extent has no shape"));
    std::vector<Point<2>> corners;
    for (const CurvePoint &point : shape)
      corners.emplace_back(point.result.torque / torque, point.result.speed / speed);
    double length = 0.;
    for (std::size_t i = 1; i < corners.size(); ++i)
      length += corners[i - 1].distance(corners[i]);

    std::vector<PointRequest> requests{{Control::torque, 0.}};
    double before         = 0.; // the length up to a corner
    std::size_t from      = 0;
    const auto of_segment = [&] { return corners[from].distance(corners[from + 1]); };
    for (unsigned int i = 1; i + 1 < n_points; ++i)
    {
      const double place = length * i / (n_points - 1);
      while (from + 2 < corners.size() && before + of_segment() < place)
        before += of_segment(), ++from;
      const Tensor<1, 2> along = corners[from + 1] - corners[from];
      const Point<2> here      = corners[from] + (place - before) / of_segment() * along;
      const bool is_steep      = std::abs(along[1]) > 1.001 * weight * std::abs(along[0]);
      if (!is_steep)
        requests.push_back({Control::torque, here[0] * torque});
      else
        requests.push_back({Control::speed, here[1] * speed});
    }
    requests.push_back({Control::speed, 0.});
    return requests;
  }

  unsigned int spacing_along_curve(const unsigned int n_points)
  {
    constexpr unsigned int widest = 4;
    return std::clamp(2 * (n_points - 1) / 5, 1u, widest);
  }

  CurveRequests::CurveRequests(const Parameters &parameters, PointTable &table,
                               const Discretisation &first)
      : parameters(parameters), table(table), first(first)
  {
    if (is_driven())
      find_driven_ends();
    else
      find_ends();
    require_bearable_torques();
    requests = is_listed() ? listed_points(parameters.loading) : points_of_curve();
    measured_points =
        MeasuredPoints(requests, is_listed() ? 1 : spacing_along_curve(requests.size()));
    table.begin_with(first, outline);
    if (!is_driven() || !is_listed())
      table.insert(first, stalled);
  }

  void CurveRequests::find_ends()
  {
    const PointRequest stall{Control::speed, 0.}, no_load{Control::torque, 0.};
    std::vector<PointRequest> ends{stall};
    if (needs_shape()) // two ranks find both at the same time
      ends.push_back(no_load);
    table.fill({{first, ends}}, PointTable::Start::rest);
    stalled           = find(stall);
    stall_torque      = stalled.result.torque;
    largest_amplitude = motor().wave.amplitude;
    // Where so many points stick at rest, friction may balance any torque.
    constexpr double sticking = 0.5;
    if (stalled.result.stick_fraction > sticking)
    {
      outline = {stalled};
      find_held_torque();
    }
    else if (needs_shape())
      outline = {find(no_load), stalled};
  }

  void CurveRequests::find_driven_ends()
  {
    // Of several waves that a voltage may sustain, the one of a free rotor is the largest. Others
    // decay from it, whatever the load and the number of ranks.
    const PointRequest stall{Control::speed, 0.}, no_load{Control::torque, 0.};
    table.fill({{first, {no_load}}}, PointTable::Start::rest);
    outline           = {find(no_load)};
    largest_amplitude = outline.front().result.amplitude;
    stalled.request   = stall;
    if (is_listed())
      return;
    table.begin_with(first, outline);
    stalled      = find(stall);
    stall_torque = stalled.result.torque;
  }

  void CurveRequests::find_held_torque()
  {
    // The computed torque is meaningless. The largest of some fractions of what friction can bear
    // under which the rotor stands still is prescribed instead, if it stands still without load.
    for (const double share : {0., 0.04, 0.1, 0.25})
    {
      table.begin_with(first, outline);
      const CurvePoint held = find({Control::torque, share * scales(motor()).borne_torque});
      if (!stands_still(held))
        return;
      outline.push_back(held);
      if (share == 0.)
        continue;
      stalled      = held;
      stall_torque = held.request.value;
    }
  }

  void CurveRequests::require_bearable_torques() const
  {
    // At a given voltage the wave may be weaker at stall than under torques beyond that of stall.
    double outermost = 0.;
    for (const CondensedMotor::Node &node : motor().nodes)
      outermost = std::max(outermost, node.radius);
    const double borne   = scales(motor()).borne_torque,
                 at_most = borne * outermost / motor().nodes.front().radius,
                 most    = is_driven()      ? at_most
                           : rotor_sticks() ? borne
                                            : stall_torque;
    const auto check     = [&](const std::string &entry, const double torque)
    {
      if (torque >= most)
        throw UserError(entry + " = " + short_text(torque) +
                        " N m is beyond the stall of the motor, which is at " + short_text(most) +
                        " N m; allowed: less than that" +
                        (entry == "Loading/Values" ? ", or Loading/Control = speed" : ""));
    };
    if (parameters.loading.control == Control::torque)
      for (const double torque : parameters.loading.values)
        check("Loading/Values", torque);
    if (is_driven())
      for (const double torque : parameters.wave.response_torques)
        check("Wave/Response torques", torque);
  }

  bool CurveRequests::needs_shape() const
  {
    return !is_listed() && parameters.loading.n_curve_points > 2;
  }

  std::vector<PointRequest> CurveRequests::points_of_curve()
  {
    if (is_driven())
      return falling_speeds();
    if (rotor_sticks())
      return rising_torques();
    if (!needs_shape())
      return {{Control::torque, 0.}, {Control::speed, 0.}};
    table.begin_with(first, outline);
    std::vector<PointRequest> rising;
    for (const double share : shares_for_shape(is_marched(parameters)))
      rising.push_back({Control::torque, share * stall_torque});
    table.fill({{first, rising}});
    outline.clear();
    for (const PointRequest &request : rising)
      outline.push_back(find(request));
    outline.push_back(stalled);
    // Without load, a rotor that hardly slips on the wave may stand still: its curve has no shape.
    return stands_still(outline.front())
               ? rising_torques()
               : points_along_curve(outline, parameters.loading.n_curve_points);
  }

  std::vector<PointRequest> CurveRequests::falling_speeds() const
  {
    const CurvePoint &free     = outline.front();
    const unsigned int n_parts = parameters.loading.n_curve_points - 1;
    std::vector<PointRequest> falling{free.request};
    if (stands_still(free))
      return falling;
    for (unsigned int i = 1; i < n_parts; ++i)
      falling.push_back({Control::speed, free.result.speed * (n_parts - i) / n_parts});
    falling.push_back(stalled.request);
    return falling;
  }

  std::vector<PointRequest> CurveRequests::rising_torques() const
  {
    const unsigned int n_parts = parameters.loading.n_curve_points - 1;
    std::vector<PointRequest> rising;
    for (unsigned int i = 0; i < n_parts; ++i)
      rising.push_back({Control::torque, stall_torque * i / n_parts});
    rising.push_back(stalled.request);
    return rising;
  }

  bool CurveRequests::stands_still(const CurvePoint &point) const
  {
    return std::abs(point.result.speed) <= AccuracyBudget(parameters.accuracy).standstill() *
                                               QuantityScales::share * scales(motor()).crest_speed;
  }

  QuantityScales CurveRequests::scales(const CondensedMotor &motor) const
  {
    return scales_of(parameters, motor, largest_amplitude, stall_torque);
  }
} // namespace ringmotor
