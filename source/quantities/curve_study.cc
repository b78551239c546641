// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/quantities/curve_search.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ringmotor
{
  double CurveSearch::point_seconds(const CurveSetting &setting)
  {
    double seconds = 0.;
    for (const auto &[request, point] : known[setting])
      seconds += point.seconds;
    return seconds;
  }

  CurveSearch::Rung CurveSearch::rung_of(const CurveSetting &setting)
  {
    reached_level = setting.level;
    if (requests.empty())
      find_requests(setting.n_parts);
    n_parts.assign(requests.size(), setting.n_parts);
    evaluate();
    const unsigned int coarse = compared_with(setting.level);
    Rung rung;
    rung.setting                = setting;
    rung.n_nodes                = motor().nodes.size();
    rung.n_dofs                 = motor().n_dofs;
    rung.n_steps                = std::lround(motor().period() / points().front().fields.time_step);
    rung.largest_error          = worst_error();
    rung.seconds                = motor_seconds[setting.level] + point_seconds(setting);
    rung.seconds_with_error_bar = motor_seconds[setting.level] + motor_seconds[coarse];
    for (const CurveSetting &used :
         std::set<CurveSetting>{setting, steps.plain(setting.level), steps.plain(coarse),
                                changed_wave(), compared_step(0)})
      rung.seconds_with_error_bar += point_seconds(used);
    return rung;
  }

  std::vector<CurveSearch::Rung>
  CurveSearch::climb(const std::function<void(const Rung &)> &after_rung)
  {
    std::vector<Rung> rungs;
    const unsigned int first  = steps.first_parts();
    const unsigned int finest = parameters.accuracy.mode == AccuracyMode::fixed
                                    ? std::max(1u, parameters.accuracy.interface_refinement)
                                    : finest_level;
    for (unsigned int level = 1; level <= finest; ++level)
    {
      motors.erase(motors.begin(), motors.lower_bound(compared_with(level)));
      // Half the step on the finest mesh would cost more than all other settings together.
      const unsigned int last = level < finest_level ? 2 * first : first;
      for (unsigned int parts = first; parts <= last; parts *= 2)
      {
        rungs.push_back(rung_of({level, parts}));
        after_rung(rungs.back());
      }
    }
    for (Rung &rung : rungs)
    {
      rung.distance = 0.;
      for (const auto &[request, point] : known[rung.setting])
        rung.distance = std::max(rung.distance, relative(change(point, results[request])));
    }
    return rungs;
  }

  CurveSearch::StaticFrictionEffect CurveSearch::static_friction_effect()
  {
    const unsigned int middle              = (requests.size() - 1) / 2;
    const bool of_torque                   = requests[middle].control == Control::torque;
    Parameters without                     = parameters;
    without.effects.static_friction_excess = EffectChoice::off;
    // Differences do not need steps so short that powers balance.
    const CurveSetting plain = steps.plain(reached_level);
    const CurvePoint &before = point_of(plain, middle);
    const CurvePoint dynamic =
        sources.points(without, motor(), plain, {requests[middle]}, {before}).front();
    const auto signed_change = [&](const CurvePoint &from, const CurvePoint &to) {
      return of_torque ? to.result.speed - from.result.speed
                       : to.result.torque - from.result.torque;
    };
    return {results[middle], signed_change(before, dynamic),
            signed_change(before, point_of(plain.halved(), middle)),
            signed_change(point_of(steps.plain(compared_with(reached_level)), middle), before)};
  }
} // namespace ringmotor
