// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/voltage_drive.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace ringmotor
{
  double VoltageDrive::detuned_square(const WaveLoad &load) const
  {
    return natural_frequency * natural_frequency * (1. + 2. * load.detuning);
  }

  double VoltageDrive::available(const WaveLoad &load) const
  {
    return force_factor * voltage / load.amplitude;
  }

  double VoltageDrive::damper(const WaveLoad &load) const
  {
    return (load.power / (load.amplitude * load.amplitude) + internal_loss) / load.frequency;
  }

  std::complex<double> VoltageDrive::stiffness(const WaveLoad &load) const
  {
    const double square = load.frequency * load.frequency;
    return {frequency ? modal_mass * (detuned_square(load) - square) : 0., damper(load)};
  }

  double VoltageDrive::spring_error(const double spring, const double detuning_error) const
  {
    return frequency ? 2. * modal_mass * natural_frequency * natural_frequency *
                               (natural_frequency_error + detuning_error) +
                           std::abs(spring) * modal_mass_error
                     : 0.;
  }

  double VoltageDrive::excess(const WaveLoad &load, const bool with_errors) const
  {
    std::complex<double> needed = stiffness(load);
    needed.imag(std::max(0., needed.imag())); // else the rotor feeds the wave
    constexpr double grows = -1.;

    double force = available(load);
    if (with_errors)
      force = force * (1. + force_factor_error) + spring_error(needed.real()) +
              internal_loss_error / load.frequency;
    return std::max(grows, std::log(std::abs(needed) / force));
  }

  std::array<double, 2> VoltageDrive::frequencies(const WaveLoad &load) const
  {
    const double force = available(load), lost = damper(load), square = detuned_square(load),
                 spring = std::sqrt(std::max(0., force * force - lost * lost)) / modal_mass;
    return {{std::sqrt(square - spring), std::sqrt(square + spring)}};
  }

  std::complex<double> VoltageDrive::motional_admittance(const WaveLoad &load,
                                                         const double at_frequency) const
  {
    const std::complex<double> needed(
        modal_mass * (detuned_square(load) - at_frequency * at_frequency), damper(load));
    return std::complex<double>(0., at_frequency) * force_factor * force_factor / needed;
  }

  std::string VoltageDrive::text() const
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << "driven by " << voltage << " V at ";
    if (frequency)
      text << *frequency << " rad/s";
    else
      text << "the resonance";
    for (const double number :
         {force_factor, modal_mass, natural_frequency, internal_loss, rotor_loss_factor,
          force_factor_error, modal_mass_error, natural_frequency_error, internal_loss_error})
      text << " " << number;
    return text.str() + "\n";
  }
} // namespace ringmotor
