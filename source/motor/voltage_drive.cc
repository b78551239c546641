// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/voltage_drive.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace ringmotor
{
  std::complex<double> VoltageDrive::stiffness(const WaveLoad &load) const
  {
    const double square = natural_frequency * natural_frequency * (1. + 2. * load.detuning),
                 spring = frequency ? modal_mass * (square - load.frequency * load.frequency) : 0.;
    return {spring,
            (load.power / (load.amplitude * load.amplitude) + internal_loss) / load.frequency};
  }

  double VoltageDrive::excess(const WaveLoad &load, const bool with_errors) const
  {
    std::complex<double> needed = stiffness(load);
    needed.imag(std::max(0., needed.imag())); // else the rotor feeds the wave
    constexpr double grows = -1.;

    double available = force_factor * voltage / load.amplitude; // N/m
    if (with_errors)
    {
      const double spring_error = frequency ? 2. * modal_mass * natural_frequency *
                                                      natural_frequency * natural_frequency_error +
                                                  std::abs(needed.real()) * modal_mass_error
                                            : 0.;
      available                 = available * (1. + force_factor_error) + spring_error +
                  internal_loss_error / load.frequency;
    }
    return std::max(grows, std::log(std::abs(needed) / available));
  }

  std::array<double, 2> VoltageDrive::frequencies(const WaveLoad &load) const
  {
    const double available = force_factor * voltage / load.amplitude,
                 damper    = stiffness(load).imag(),
                 spring =
                     std::sqrt(std::max(0., available * available - damper * damper)) / modal_mass,
                 square = natural_frequency * natural_frequency * (1. + 2. * load.detuning);
    return {{std::sqrt(square - spring), std::sqrt(square + spring)}};
  }

  std::complex<double> VoltageDrive::motional_admittance(const WaveLoad &load,
                                                         const double at_frequency) const
  {
    const double square = natural_frequency * natural_frequency * (1. + 2. * load.detuning);
    const std::complex<double> needed(modal_mass * (square - at_frequency * at_frequency),
                                      stiffness(load).imag());
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
