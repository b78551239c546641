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
    first_curve = curve;
    points.clear();
    for (const CurvePoint &point : first_curve)
      insert(discretisation, point);
  }

  void PointTable::drop_other_fields(const Needs &needs)
  {
    std::set<std::pair<Discretisation, PointRequest>> needed;
    std::size_t n_bytes = 0;
    for (const auto &[discretisation, requests] : needs)
      for (const PointRequest &request : requests)
      {
        needed.emplace(discretisation, request);
        n_bytes += at(discretisation, request).fields.n_bytes();
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
    if (const std::optional<Points> other =
            starts_on_other_mesh(discretisation, requests, steps.longest()))
      return *other;
    Points starts;
    if (start == Start::rest)
      starts.resize(requests.size());
    else if (!first_curve.empty())
      for (const PointRequest &request : requests)
        starts.push_back(similar_point(first_curve, request));
    return starts;
  }

  PointTable::Points PointTable::marched_starts(const Discretisation &discretisation,
                                                const std::vector<PointRequest> &requests)
  {
    const auto [level, modes_level] = std::pair(discretisation.level, discretisation.modes_level);
    if (const std::optional<Points> same = known({level, modes_level, steps.plain()}, requests))
      return *same;
    if (const std::optional<Points> other =
            starts_on_other_mesh(discretisation, requests, steps.plain()))
      return *other;
    Points others, starts;
    if (const auto found = points.find({level, modes_level, steps.plain()}); found != points.end())
      for (const auto &[request, point] : found->second)
        others.push_back(point);
    if (!others.empty())
      for (const PointRequest &request : requests)
        starts.push_back(similar_point(others, request));
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
                                   const std::vector<PointRequest> &requests,
                                   const Steps &of_starts)
  {
    for (const auto &[levels, timed] : motors)
    {
      const auto &[modes_level, level] = levels;
      if (modes_level != discretisation.modes_level || level == discretisation.level)
        continue;
      std::optional<Points> starts = known({level, modes_level, of_starts}, requests);
      if (!starts)
        continue;
      const MeshTransfer transfer(timed->motor, motor(discretisation.level, modes_level));
      for (CurvePoint &point : *starts)
        if (!is_marched(parameters))
          point.fields = transfer.fields(point.fields);
        else if (point.end.is_known())
          point.end = transfer.marched(point.end);
      return starts;
    }
    return {};
  }

  const CurvePoint &PointTable::similar_point(const Points &points, const PointRequest &request)
  {
    const PointQuantity &load = prescribed(request);
    const auto distance       = [&](const CurvePoint &point)
    { return std::abs(load.value(point) - request.value); };
    return *std::min_element(points.begin(), points.end(),
                             [&](const CurvePoint &one, const CurvePoint &other)
                             { return distance(one) < distance(other); });
  }
} // namespace ringmotor
