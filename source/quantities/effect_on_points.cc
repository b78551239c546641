// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/quantities/effect_on_points.h>
#include <ringmotor/quantities/point_quantities.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ringmotor
{
  EffectOnPoints effect_on_points(const Parameters &all_parameters, const Effect &effect,
                                  const StatorWave &wave, const RotorVibration &vibration)
  {
    Parameters with = all_parameters, without = all_parameters;
    with.time.scheme = without.time.scheme = TimeScheme::steady;
    with.effects.*effect.entry             = EffectChoice::on;
    without.effects.*effect.entry          = EffectChoice::off;
    const auto condensed                   = [&](const Parameters &parameters)
    { return condense_motor(parameters, wave, ContactDiscretisation::level(0), 1, &vibration); };
    const CondensedMotor motor_with = condensed(with), motor_without = condensed(without);
    OperatingPointFinder finder_with(with, motor_with), finder_without(without, motor_without);

    const CurvePoint stall   = finder_without.find({Control::speed, 0.}),
                     no_load = finder_without.find({Control::torque, 0.});
    const PointRequest half{Control::torque, 0.5 * stall.result.torque};
    CurvePoint middle = finder_without.find(half);
    if (with.loading.control == Control::speed)
      middle.request = {Control::speed, middle.result.speed};
    EffectOnPoints effect_on;
    try
    {
      for (const CurvePoint &point : {no_load, middle, stall})
      {
        const PointError here = change(point, finder_with.find(point.request));
        for (double PointError::*const quantity : PointError::members)
          effect_on.change.*quantity = std::max(effect_on.change.*quantity, here.*quantity);
      }
      effect_on.relative = std::max(effect_on.change.speed / no_load.result.speed,
                                    effect_on.change.torque / stall.result.torque);
    }
    catch (const ComputationError &)
    {
      effect_on.relative = std::numeric_limits<double>::infinity();
    }
    return effect_on;
  }

  LeftOut::LeftOut(const std::vector<EffectRow> &rows,
                   const std::map<std::string, EffectOnPoints> &measured)
  {
    for (const EffectRow &row : rows)
      if (row.is_left_out())
      {
        const auto of_points = measured.find(row.name);
        if (of_points == measured.end())
        {
          relative += std::abs(*row.indicator);
          continue;
        }
        others += of_points->second.change;
      }
  }

  PointError LeftOut::of(const CurvePoint &point) const
  {
    PointError error = change(CurvePoint(), point); // its values
    error *= relative;
    error += others;
    error.*prescribed(point.request).error = 0.; // does not change
    return error;
  }
} // namespace ringmotor
