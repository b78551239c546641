// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/points/mesh_transfer.h>
#include <ringmotor/points/point_quantities.h>
#include <ringmotor/points/point_table.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ringmotor
{
  PointTable::PointTable(const Parameters &parameters, const StepChoice &steps, PointSource &source)
      : parameters(parameters), steps(steps), source(source)
  {
  }

  void PointTable::condense(const std::vector<unsigned int> &levels, const unsigned int modes_level)
  {
    std::vector<unsigned int> missing;
    for (const unsigned int level : levels)
      if (motors.count({modes_level, level}) == 0)
        missing.push_back(level);
    if (missing.empty())
      return;
    std::vector<TimedMotor> condensed = source.motors(missing, modes_level);
    for (std::size_t i = 0; i < missing.size(); ++i)
      motors[{modes_level, missing[i]}] =
          std::make_unique<const TimedMotor>(std::move(condensed[i]));
  }

  const CondensedMotor &PointTable::motor(const unsigned int level, const unsigned int modes_level)
  {
    condense({level}, modes_level);
    return motors.at({modes_level, level})->motor;
  }

  void PointTable::drop_motors(const unsigned int below_level,
                               const unsigned int other_than_modes_level)
  {
    for (auto motor = motors.begin(); motor != motors.end();)
    {
      const auto [modes_level, level] = motor->first;
      const bool is_used = modes_level == other_than_modes_level && level >= below_level;
      motor              = is_used ? std::next(motor) : motors.erase(motor);
    }
  }

  void PointTable::fill(const Needs &needs, const Start start)
  {
    std::map<Discretisation, std::set<PointRequest>> asked;
    std::vector<PointSet> sets;
    for (const auto &[discretisation, requests] : needs)
    {
      std::vector<PointRequest> missing;
      for (const PointRequest &request : requests)
        if (!find(discretisation, request) && asked[discretisation].insert(request).second)
          missing.push_back(request);
      if (missing.empty())
        continue;
      Points starts = starts_for(discretisation, missing, start); // may fill others
      sets.push_back({discretisation, motor(discretisation.level, discretisation.modes_level),
                      std::move(missing), std::move(starts)});
    }
    if (sets.empty())
      return;
    const std::vector<Points> found = source.points(sets);
    for (std::size_t i = 0; i < sets.size(); ++i)
      for (const CurvePoint &point : found[i])
        insert(sets[i].discretisation, point);
  }

  const CurvePoint &PointTable::at(const Discretisation &discretisation,
                                   const PointRequest &request)
  {
    fill({{discretisation, {request}}});
    return points.at(discretisation).at(request);
  }

  const CurvePoint *PointTable::find(const Discretisation &discretisation,
                                     const PointRequest &request) const
  {
    const auto of_discretisation = points.find(discretisation);
    if (of_discretisation == points.end())
      return nullptr;
    const auto point = of_discretisation->second.find(request);
    return point == of_discretisation->second.end() ? nullptr : &point->second;
  }

  void PointTable::begin_with(const Discretisation &discretisation, const Points &curve)
  {
    points.clear();
    for (const CurvePoint &point : curve)
      insert(discretisation, point);
    first_curve          = points[discretisation];
    level_of_first_curve = discretisation.level;
  }

  void PointTable::drop_other_fields(const Needs &needs)
  {
    std::set<std::pair<Discretisation, PointRequest>> needed;
    std::size_t n_bytes = 0;
    for (const auto &[discretisation, requests] : needs)
      for (const PointRequest &request : requests)
        if (const CurvePoint *const point = find(discretisation, request))
        {
          needed.emplace(discretisation, request);
          n_bytes += point->fields.n_bytes();
        }
    for (auto &[discretisation, of_requests] : points)
      for (auto &[request, point] : of_requests)
      {
        const bool is_needed = needed.count({discretisation, request}) > 0;
        if (point.fields.state.force.empty() || (is_needed && may_be_kept(n_bytes)))
          continue;
        ContactFields fields = std::move(point.fields);
        point.fields.drop_values();
        source.replace(discretisation, point);
        if (is_needed)
          point.fields = std::move(fields);
      }
  }

  void PointTable::restore_fields(const Needs &needs)
  {
    std::vector<PointSet> lost;
    for (const auto &[discretisation, requests] : needs)
    {
      std::vector<PointRequest> these;
      for (const PointRequest &request : requests)
        if (at(discretisation, request).fields.state.force.empty())
          these.push_back(request);
      if (!these.empty())
        lost.push_back({discretisation,
                        motor(discretisation.level, discretisation.modes_level),
                        these,
                        {},
                        /*anew =*/true});
    }
    if (lost.empty())
      return;
    const std::vector<Points> found = source.points(lost);
    std::size_t n_bytes             = 0;
    for (const Points &of_set : found)
      for (const CurvePoint &point : of_set)
        n_bytes += point.fields.n_bytes();
    for (std::size_t i = 0; i < lost.size(); ++i)
      for (const CurvePoint &point : found[i])
      {
        insert(lost[i].discretisation, point);
        if (may_be_kept(n_bytes))
          source.replace(lost[i].discretisation, point);
      }
  }

  bool PointTable::may_be_kept(const std::size_t n_bytes)
  {
    constexpr std::size_t most = 100'000'000;
    return n_bytes <= most;
  }

  double PointTable::seconds(const Discretisation &discretisation) const
  {
    double seconds = 0.;
    if (const auto known = points.find(discretisation); known != points.end())
      for (const auto &[request, point] : known->second)
        seconds += point.seconds;
    return seconds;
  }

  double PointTable::motor_seconds(const unsigned int level, const unsigned int modes_level) const
  {
    return motors.at({modes_level, level})->seconds;
  }

  std::optional<PointTable::Points>
  PointTable::known(const Discretisation &discretisation,
                    const std::vector<PointRequest> &requests) const
  {
    Points all;
    for (const PointRequest &request : requests)
      if (const CurvePoint *const point = find(discretisation, request))
        all.push_back(*point);
      else
        return {};
    return all;
  }

  PointTable::Points PointTable::starts_for(const Discretisation &discretisation,
                                            const std::vector<PointRequest> &requests,
                                            const Start start)
  {
    if (is_marched(parameters))
      return marched_starts(discretisation, requests);
    Discretisation with_coarser_modes = discretisation;
    if (with_coarser_modes.modes_level-- > 0)
      if (const std::optional<Points> coarser = known(with_coarser_modes, requests))
        return *coarser;
    if (!(discretisation == discretisation.with(steps.longest())))
      return starts_with_longer_steps(discretisation, requests, start);
    if (const std::optional<Points> other = starts_on_other_mesh(discretisation, requests))
      return *other;
    if (start == Start::rest)
      return Points(requests.size());
    if (!first_curve.empty())
      return starts_from_first_curve(discretisation, requests);
    return first_curve_is_left ? similar_points(discretisation, requests) : Points();
  }

  PointTable::Points PointTable::marched_starts(const Discretisation &discretisation,
                                                const std::vector<PointRequest> &requests)
  {
    const unsigned int modes_level = discretisation.modes_level;
    Points starts            = similar_points(discretisation.with(discretisation.steps), requests);
    const auto use_if_closer = [&](Points others, const MeshTransfer *const transfer)
    {
      if (starts.empty())
        starts.resize(others.size());
      for (std::size_t i = 0; i < others.size(); ++i)
        if (others[i].end.is_known() &&
            (!starts[i].end.is_known() ||
             distance(others[i], requests[i]) < distance(starts[i], requests[i])))
        {
          starts[i] = std::move(others[i]);
          if (transfer)
            starts[i].end = transfer->marched(starts[i].end);
        }
    };
    use_if_closer(similar_points({discretisation.level, modes_level, steps.plain()}, requests),
                  nullptr);
    for (const auto &[levels, timed] : motors)
      if (levels.first == modes_level && levels.second != discretisation.level)
      {
        const MeshTransfer transfer(timed->motor, motor(discretisation.level, modes_level));
        use_if_closer(similar_points({levels.second, modes_level, steps.plain()}, requests),
                      &transfer);
      }
    for (CurvePoint &point : starts)
      point.fields.drop_values(); // much memory, and of no use to them
    return starts;
  }

  PointTable::Points PointTable::similar_points(const Discretisation &discretisation,
                                                const std::vector<PointRequest> &requests) const
  {
    Points starts;
    const auto found = points.find(discretisation);
    if (found == points.end() || found->second.empty())
      return starts;
    // Of several waves that a voltage may sustain, the largest one is meant.
    const auto largest =
        std::max_element(found->second.begin(), found->second.end(),
                         [](const auto &one, const auto &other)
                         { return one.second.result.amplitude < other.second.result.amplitude; });
    for (const PointRequest &request : requests)
      starts.push_back(parameters.wave.drive == Drive::voltage
                           ? largest->second
                           : similar_point(found->second, request));
    return starts;
  }

  PointTable::Points PointTable::starts_with_longer_steps(const Discretisation &discretisation,
                                                          const std::vector<PointRequest> &requests,
                                                          const Start start)
  {
    std::vector<PointRequest> without;
    for (const PointRequest &request : requests)
      if (!point_with_longer_steps(discretisation, request))
        without.push_back(request);
    fill({{with_longer_steps(discretisation), without}}, start);
    Points starts;
    for (const PointRequest &request : requests)
      starts.push_back(*point_with_longer_steps(discretisation, request));
    return starts;
  }

  Discretisation PointTable::with_longer_steps(const Discretisation &discretisation) const
  {
    return discretisation.with(discretisation.variation || discretisation.steps.n_parts % 2 != 0
                                   ? steps.plain()
                                   : discretisation.steps.doubled());
  }

  const CurvePoint *PointTable::point_with_longer_steps(const Discretisation &discretisation,
                                                        const PointRequest &request) const
  {
    if (!discretisation.variation)
      for (unsigned int parts = discretisation.steps.n_parts - 1; parts > 1; --parts)
        if (const CurvePoint *const point = find(discretisation.with(Steps{parts}), request))
          return point;
    return find(with_longer_steps(discretisation), request);
  }

  std::optional<PointTable::Points>
  PointTable::starts_on_other_mesh(const Discretisation &discretisation,
                                   const std::vector<PointRequest> &requests)
  {
    for (const auto &[levels, timed] : motors)
    {
      const auto &[modes_level, level] = levels;
      if (modes_level != discretisation.modes_level || level == discretisation.level)
        continue;
      std::optional<Points> starts = known({level, modes_level, steps.longest()}, requests);
      if (!starts)
        continue;
      return transferred(std::move(*starts), level, discretisation);
    }
    return {};
  }

  PointTable::Points PointTable::starts_from_first_curve(const Discretisation &discretisation,
                                                         const std::vector<PointRequest> &requests)
  {
    Points starts;
    for (const PointRequest &request : requests)
      starts.push_back(similar_point(first_curve, request));
    return transferred(std::move(starts), level_of_first_curve, discretisation);
  }

  PointTable::Points PointTable::transferred(Points starts, const unsigned int from_level,
                                             const Discretisation &discretisation)
  {
    if (from_level == discretisation.level)
      return starts;
    const MeshTransfer transfer(motor(from_level, discretisation.modes_level),
                                motor(discretisation.level, discretisation.modes_level));
    for (CurvePoint &point : starts)
      point.fields = transfer.fields(point.fields);
    return starts;
  }

  const CurvePoint &PointTable::similar_point(const ByRequest &points, const PointRequest &request)
  {
    return std::min_element(
               points.begin(), points.end(),
               [&](const auto &one, const auto &other)
               { return distance(one.second, request) < distance(other.second, request); })
        ->second;
  }

  double PointTable::distance(const CurvePoint &point, const PointRequest &request)
  {
    return point.request == request ? 0.
                                    : std::abs(prescribed(request).value(point) - request.value);
  }
} // namespace ringmotor
