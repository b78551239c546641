// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/loaded_wave.h>

#include <cmath>

namespace ringmotor
{
  LoadedWave::LoadedWave(const CondensedMotor &motor, const MotorModel &model,
                         const SteadyStep &step)
      : motor(motor), model(model), step(step),
        steady(std::make_unique<SteadyDriver>(motor, model.friction, step))
  {
  }

  OperatingState LoadedWave::at(const RotorLoad &load, const double amplitude,
                                const double frequency)
  {
    const CondensedMotor &now = other ? *other : motor;
    if (amplitude != now.amplitude || frequency != now.angular_frequency)
    {
      if (!other)
        other = std::make_unique<CondensedMotor>(motor);
      const double factor = amplitude == motor.amplitude ? 1. : amplitude / motor.amplitude;
      for (std::size_t i = 0; i < motor.nodes.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          other->nodes[i].free_motion[c] = factor * motor.nodes[i].free_motion[c];
      other->amplitude         = amplitude;
      other->wave_energy       = factor * factor * motor.wave_energy;
      other->angular_frequency = frequency;
      auto driver              = std::make_unique<SteadyDriver>(*other, model.friction, step);
      driver->go_on_as(*steady);
      steady = std::move(driver);
    }
    return steady->at(load);
  }

  void shifted_wave::require_settled(const RootEnd end, const double place, const double excess)
  {
    if (end == RootEnd::escaped || end == RootEnd::endless)
      throw ComputationError("the frequency of the wave with the rotor on the stator did not "
                             "settle; at " +
                             short_text(place) + " times that without rotor it is off by " +
                             short_text(-excess) +
                             ": choose shorter steps (a larger Time/Snapshots), or "
                             "Effects/Stator back-reaction = off");
  }

  bool driven_wave::is_balanced(const double excess, const double width)
  {
    // Beside a change of the state of a contact node the forces jump a little.
    constexpr double settled = 1e-5, small_jump = 3e-4, narrow_for_it = 1e-4;
    return excess <= settled || (excess < small_jump && width < narrow_for_it);
  }

  void driven_wave::require_balance(const RootEnd end, const double start, const double place,
                                    const double excess, const double beyond)
  {
    if (end == RootEnd::endless)
      throw ComputationError("the amplitude of the wave did not settle; at " + short_text(place) +
                             " m its forces are out of balance by " + short_text(excess));
    if (end == RootEnd::escaped)
      throw ComputationError("the wave " + std::string(place < start ? "decays" : "grows") +
                             " beyond " + short_text(place) +
                             " m without a balance of its forces; choose another Wave/Voltage, "
                             "Wave/Frequency or load");
    if (end == RootEnd::jump && std::abs(excess) > largest_excess)
      throw ComputationError("no amplitude balances the voltage: at " + short_text(place) +
                             " m the forces of the contact on the wave jump by " +
                             short_text(std::abs(beyond - excess)) +
                             "; choose shorter steps (a larger Time/Snapshots) or another "
                             "Wave/Voltage");
  }
} // namespace ringmotor
