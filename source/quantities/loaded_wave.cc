// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/quantities/loaded_wave.h>
#include <ringmotor/quantities/operating_point.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ringmotor
{
  LoadedWave::LoadedWave(const CondensedMotor &motor, const MotorModel &model,
                         const SteadyStep &step)
      : motor(motor), model(model), step(step), frequency(motor.angular_frequency),
        steady(std::make_unique<SteadyDriver>(motor, model.friction, step))
  {
  }

  OperatingState LoadedWave::at_frequency(const RotorLoad &load, const double amplitude)
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

  OperatingState LoadedWave::at(const RotorLoad &load, const double amplitude)
  {
    OperatingState state = at_frequency(load, amplitude);
    if (!model.wave_feels_contact)
      return state;
    // The frequency at which the state found there has the detuning that this frequency requires:
    // the root of excess(). With inertia the state depends on the frequency, so that mere
    // repetition converges slowly, beside a resonance not at all; the secant needs no slope.
    constexpr unsigned int most_rounds = 20;
    constexpr double settled           = 1e-8;
    const auto excess                  = [&]()
    { return motor.angular_frequency * (1. + detuning(state)) - frequency; };
    double excess_before = excess(), move = excess_before;
    const double longest = std::abs(move);
    for (unsigned int round = 0; round < most_rounds; ++round)
    {
      frequency += move;
      state                = at_frequency(load, amplitude);
      const double remains = excess();
      if (std::abs(remains) <= settled * frequency)
        return state;
      const double change = remains - excess_before;
      move = change == 0. ? remains : std::clamp(-move * remains / change, -longest, longest);
      excess_before = remains;
    }
    throw ComputationError("the frequency of the wave with the rotor on the stator did not settle "
                           "in " +
                           std::to_string(most_rounds) + " iterations");
  }

  BalancedAmplitude balanced_amplitude(const double start,
                                       const std::function<double(double)> &excess)
  {
    constexpr unsigned int most_rounds = 60;
    constexpr double settled = 1e-5, longest = 0.4, least_slope = 0.05, range = 100.;
    // Beside a change of the state of a contact point the forces jump a little.
    constexpr double narrow = 1e-4, small_jump = 3e-4, very_narrow = 3e-6;
    struct End
    {
      double place, value;
    };
    // In logarithms. The force of the voltage over that of dampers and springs falls with the
    // amplitude to a power of about one, the first slope. Between the largest amplitude that is
    // known to grow and the smallest one that is known to decay.
    std::optional<End> growing, decaying;
    double place = std::log(start), value = excess(start), slope = 1., slope_before = slope;
    for (unsigned int round = 0; round < most_rounds; ++round)
    {
      BalancedAmplitude found{std::exp(place), std::abs(value) / slope};
      if (std::abs(value) <= settled)
        return found;
      (value < 0. ? growing : decaying) = End{place, value};
      double move                       = std::clamp(-value / slope, -longest, longest);
      if (growing && decaying)
      {
        const double width = std::abs(decaying->place - growing->place);
        if (width < narrow)
        {
          found.uncertainty = std::max(width, std::abs(value) / slope_before);
          if (std::abs(value) < (width < very_narrow ? found.largest_excess : small_jump))
            return found;
          if (width < 1e-3 * very_narrow)
            throw ComputationError(
                "no amplitude balances the voltage: at " + short_text(found.value) +
                " m the forces of the contact on the wave jump by " +
                short_text(decaying->value - growing->value) +
                "; choose shorter steps (a larger Time/Snapshots) or another Wave/Voltage");
        }
        const double next = place + move;
        // Inside, beside the middle where the secant gains little.
        const bool is_inside = (next - growing->place) * (next - decaying->place) < 0.;
        if (!is_inside || (round % 4 == 3 && std::abs(move) > 0.1 * width))
          move = 0.5 * (growing->place + decaying->place) - place;
      }
      place += move;
      if (std::abs(place - std::log(start)) > std::log(range))
        throw ComputationError("the wave " + std::string(move < 0. ? "decays" : "grows") +
                               " beyond " + short_text(std::exp(place)) +
                               " m without a balance of its forces; choose another Wave/Voltage, "
                               "Wave/Frequency or load");
      const double before = value;
      value               = excess(std::exp(place));
      slope_before        = slope;
      slope               = std::max((value - before) / move, least_slope);
    }
    throw ComputationError("the amplitude of the wave did not settle in " +
                           std::to_string(most_rounds) + " iterations");
  }
} // namespace ringmotor
