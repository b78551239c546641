// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/rotor_modes.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/quantities/inertia_effect.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace ringmotor
{
  PointError InertiaEffect::left_out_of(const CurvePoint &point) const
  {
    const bool of_torque = point.request.control == Control::torque;
    return {of_torque ? speed : 0., of_torque ? 0. : torque, loss * point.result.friction_loss(),
            loss * point.rotor_power};
  }

  InertiaEffect inertia_effect(const Parameters &all_parameters, const StatorWave &wave)
  {
    const auto begin                 = std::chrono::steady_clock::now();
    Parameters parameters            = all_parameters;
    parameters.effects.rotor_inertia = EffectChoice::off;
    parameters.time.scheme           = TimeScheme::steady;
    const CondensedMotor at_rest =
        condense_motor(parameters, wave, ContactDiscretisation::level(0));
    parameters.effects.rotor_inertia = EffectChoice::on;
    const RotorVibration vibration =
        RotorVibration::coarse_only(parameters, wave.angular_frequency);
    const CondensedMotor vibrating =
        condense_motor(parameters, wave, ContactDiscretisation::level(0), &vibration);

    OperatingPointFinder quasistatic(parameters, at_rest), dynamic(parameters, vibrating);
    const bool of_torque         = parameters.loading.control == Control::torque;
    const OperatingPoint stall   = quasistatic.find({Control::speed, 0.}).result,
                         no_load = quasistatic.find({Control::torque, 0.}).result,
                         middle  = quasistatic.find({Control::torque, 0.5 * stall.torque}).result;
    const PointRequest half      = of_torque ? PointRequest{Control::torque, middle.torque}
                                             : PointRequest{Control::speed, middle.speed};
    InertiaEffect effect;
    try
    {
      const OperatingPoint first  = dynamic.find({Control::torque, 0.}).result,
                           second = dynamic.find(half).result,
                           last   = dynamic.find({Control::speed, 0.}).result;
      effect.speed =
          std::max(std::abs(first.speed - no_load.speed), std::abs(second.speed - middle.speed));
      effect.torque =
          std::max(std::abs(second.torque - middle.torque), std::abs(last.torque - stall.torque));
      effect.loss     = std::max(std::abs(first.friction_loss() / no_load.friction_loss() - 1.),
                                 std::abs(second.friction_loss() / middle.friction_loss() - 1.));
      effect.relative = std::max(effect.speed / no_load.speed, effect.torque / stall.torque);
    }
    catch (const ComputationError &)
    {
      effect.relative = std::numeric_limits<double>::infinity();
    }
    effect.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return effect;
  }
} // namespace ringmotor
