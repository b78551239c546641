// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/curve_search.h>

#include <algorithm>

namespace ringmotor
{
  double CurveSearch::point_seconds(const CurveSetting &setting)
  {
    double seconds = 0.;
    for (const auto &[request, point] : known[setting])
      seconds += point.seconds;
    return seconds;
  }

  Parameters CurveSearch::frozen() const
  {
    Parameters frozen =
        with_parts_of_a_step(parameters, *std::max_element(n_parts.begin(), n_parts.end()));
    frozen.accuracy.mode                 = AccuracyMode::fixed;
    frozen.accuracy.interface_refinement = reached_level;
    frozen.accuracy.rotor_modes          = modes_level;
    return frozen;
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
