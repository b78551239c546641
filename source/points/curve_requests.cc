// SPDX-License-Identifier: LGPL-2.1-or-later
// Which operating points a search looks for: those that are listed, or those along a curve.
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/curve_points.h>
#include <ringmotor/points/curve_search.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  void CurveSearch::find_ends()
  {
    const CurveSetting setting = steps.plain(reached_level);
    requests                   = {{Control::speed, 0.}};
    if (needs_shape()) // two ranks find both at the same time
      requests.push_back({Control::torque, 0.});
    find_points_of(setting, all_requests(), /*from_rest =*/true);
    stalled           = point_of(setting, 0);
    stall_torque      = stalled.result.torque;
    largest_amplitude = motor().amplitude;
    if (may_stand_still())
    {
      outline = {stalled};
      find_held_torque();
    }
    else if (needs_shape())
      outline = {point_of(setting, 1), stalled};
  }

  void CurveSearch::find_driven_ends()
  {
    // Of several waves that a voltage may sustain, the one of a free rotor is the largest. Others
    // decay from it, whatever the load and the number of ranks.
    requests = {{Control::torque, 0.}};
    find_points_of(steps.plain(reached_level), {0}, /*from_rest =*/true);
    const CurvePoint free = point_of(steps.plain(reached_level), 0);
    outline               = {free};
    largest_amplitude     = free.result.amplitude;
    stalled.request       = {Control::speed, 0.};
    if (!parameters.loading.values.empty())
      return;
    known.clear();
    requests     = {stalled.request};
    stalled      = point_of(steps.plain(reached_level), 0);
    stall_torque = stalled.result.torque;
  }

  void CurveSearch::find_requests(const unsigned int n_parts_to_start_with)
  {
    if (is_driven())
      find_driven_ends();
    else
      find_ends();
    require_bearable_torques();
    requests =
        parameters.loading.values.empty() ? points_of_curve() : listed_points(parameters.loading);
    known.clear();
    recognise(outline);
    if (!is_driven() || parameters.loading.values.empty())
      recognise({stalled});
    n_parts.assign(requests.size(), n_parts_to_start_with);
  }

  void CurveSearch::require_bearable_torques() const
  {
    // At a given voltage the wave may be weaker at stall than under torques beyond that of stall.
    double outermost = 0.;
    for (const CondensedMotor::Node &node : motor().nodes)
      outermost = std::max(outermost, node.radius);
    const double at_most = borne_torque() * outermost / motor().nodes.front().radius;
    const double most    = is_driven() ? at_most : rotor_sticks() ? borne_torque() : stall_torque;
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

  void CurveSearch::recognise(const std::vector<CurvePoint> &points)
  {
    for (const CurvePoint &point : points)
      for (const unsigned int i : all_requests())
        if (requests[i] == point.request)
          known[steps.plain(reached_level)][i] = point;
  }

  bool CurveSearch::needs_shape() const
  {
    return parameters.loading.values.empty() && parameters.loading.n_curve_points > 2;
  }

  std::vector<PointRequest> CurveSearch::points_of_curve()
  {
    if (is_driven())
      return falling_speeds();
    if (rotor_sticks())
      return rising_torques();
    if (!needs_shape())
      return {{Control::torque, 0.}, {Control::speed, 0.}};
    known.clear();
    requests.clear();
    for (const double share : shares_for_shape())
      requests.push_back({Control::torque, share * stall_torque});
    recognise(outline);
    const CurveSetting setting = steps.plain(reached_level);
    find_points_of(setting, all_requests());
    std::vector<CurvePoint> shape;
    for (const unsigned int i : all_requests())
      shape.push_back(point_of(setting, i));
    shape.push_back(stalled);
    outline = shape;
    // Without load, a rotor that hardly slips on the wave may stand still: its curve has no shape.
    return stands_still(shape.front())
               ? rising_torques()
               : points_along_curve(shape, parameters.loading.n_curve_points);
  }

  std::vector<PointRequest> CurveSearch::falling_speeds() const
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

  std::vector<PointRequest> CurveSearch::rising_torques() const
  {
    const unsigned int n_parts = parameters.loading.n_curve_points - 1;
    std::vector<PointRequest> rising;
    for (unsigned int i = 0; i < n_parts; ++i)
      rising.push_back({Control::torque, stall_torque * i / n_parts});
    rising.push_back(stalled.request);
    return rising;
  }

  bool CurveSearch::stands_still(const CurvePoint &point) const
  {
    return std::abs(point.result.speed) <= parameters.accuracy.contact_target *
                                               QuantityScales::share *
                                               crest_speed(largest_amplitude);
  }

  void CurveSearch::find_held_torque()
  {
    // Where friction balances any torque at rest, the computed one is meaningless. The largest of
    // some fractions of what friction can bear under which the rotor stands still is prescribed
    // instead, if it stands still without load.
    for (const double share : {0., 0.04, 0.1, 0.25})
    {
      known.clear();
      requests              = {{Control::torque, share * borne_torque()}};
      const CurvePoint held = point_of(steps.plain(reached_level), 0);
      if (!stands_still(held))
        return;
      outline.push_back(held);
      if (share == 0.)
        continue;
      stalled      = held;
      stall_torque = held.request.value;
    }
  }

  double CurveSearch::borne_torque() const
  {
    return parameters.friction.dynamic_coefficient * parameters.loading.preload *
           motor().nodes.front().radius;
  }

  double CurveSearch::crest_speed(const double amplitude) const
  {
    return motor().crest_speed() * (amplitude / motor().amplitude);
  }

  bool CurveSearch::may_stand_still() const
  {
    return stalled.result.stick_fraction > 0.5;
  }
} // namespace ringmotor
