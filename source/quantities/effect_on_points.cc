// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/quantities/effect_on_points.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ringmotor
{
  EffectOnPoints effect_on_points(const Parameters &all_parameters, const Effect &effect,
                                  const StatorWave &wave)
  {
    Parameters parameters                = all_parameters;
    parameters.time.scheme               = TimeScheme::steady;
    parameters.effects.*effect.entry     = EffectChoice::off;
    const ContactDiscretisation coarsest = ContactDiscretisation::level(0);
    const CondensedMotor without         = condense_motor(parameters, wave, coarsest);
    OperatingPointFinder finder_without(parameters, without);
    parameters.effects.*effect.entry = EffectChoice::on;
    const RotorVibration vibration =
        RotorVibration::coarse_only(parameters, wave.angular_frequency);
    const CondensedMotor with = condense_motor(parameters, wave, coarsest, &vibration);
    OperatingPointFinder finder_with(parameters, with);

    const bool of_torque         = parameters.loading.control == Control::torque;
    const OperatingPoint stall   = finder_without.find({Control::speed, 0.}).result,
                         no_load = finder_without.find({Control::torque, 0.}).result,
                         middle = finder_without.find({Control::torque, 0.5 * stall.torque}).result;
    const PointRequest half     = of_torque ? PointRequest{Control::torque, middle.torque}
                                            : PointRequest{Control::speed, middle.speed};
    EffectOnPoints change;
    try
    {
      const OperatingPoint first  = finder_with.find({Control::torque, 0.}).result,
                           second = finder_with.find(half).result,
                           last   = finder_with.find({Control::speed, 0.}).result;
      change.speed =
          std::max(std::abs(first.speed - no_load.speed), std::abs(second.speed - middle.speed));
      change.torque =
          std::max(std::abs(second.torque - middle.torque), std::abs(last.torque - stall.torque));
      change.loss     = std::max(std::abs(first.friction_loss() / no_load.friction_loss() - 1.),
                                 std::abs(second.friction_loss() / middle.friction_loss() - 1.));
      change.relative = std::max(change.speed / no_load.speed, change.torque / stall.torque);
    }
    catch (const ComputationError &)
    {
      change.relative = std::numeric_limits<double>::infinity();
    }
    return change;
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
        others.speed += of_points->second.speed;
        others.torque += of_points->second.torque;
        others.loss += of_points->second.loss;
      }
  }

  PointError LeftOut::of(const CurvePoint &point) const
  {
    const OperatingPoint &result = point.result;
    const bool of_torque         = point.request.control == Control::torque;
    const double loss            = relative + others.loss;
    return {of_torque ? relative * std::abs(result.speed) + others.speed : 0.,
            of_torque ? 0. : relative * std::abs(result.torque) + others.torque,
            loss * result.friction_loss(), loss * point.rotor_power};
  }
} // namespace ringmotor
