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
    return natural_frequency.value * natural_frequency.value * (1. + 2. * load.detuning);
  }

  double VoltageDrive::available(const WaveLoad &load) const
  {
    return force_factor.value * voltage / load.amplitude;
  }

  double VoltageDrive::damper(const WaveLoad &load) const
  {
    return (load.power / (load.amplitude * load.amplitude) + internal_loss.value) / load.frequency;
  }

  std::complex<double> VoltageDrive::stiffness(const WaveLoad &load) const
  {
    return {spring(load, load.detuning).value, damper(load)};
  }

  Estimate VoltageDrive::spring(const WaveLoad &load, const Estimate &detuning) const
  {
    if (!frequency)
      return {};
    const double square  = load.frequency * load.frequency,
                 natural = modal_mass.value * natural_frequency.value * natural_frequency.value;
    return modal_mass.relative() * (modal_mass.value * (detuned_square(load) - square)) +
           2. * natural * (natural_frequency.relative().deviation() + detuning.deviation());
  }

  double VoltageDrive::excess(const WaveLoad &load, const bool with_errors) const
  {
    std::complex<double> needed = stiffness(load);
    needed.imag(std::max(0., needed.imag())); // else the rotor feeds the wave
    constexpr double grows = -1.;

    double force = available(load);
    if (with_errors)
      force = force * (1. + force_factor.relative_error()) + spring(load, load.detuning).error() +
              internal_loss.error() / load.frequency;
    return std::max(grows, std::log(std::abs(needed) / force));
  }

  std::array<double, 2> VoltageDrive::frequencies(const WaveLoad &load) const
  {
    const double force = available(load), lost = damper(load), square = detuned_square(load),
                 spring = std::sqrt(std::max(0., force * force - lost * lost)) / modal_mass.value;
    return {{std::sqrt(square - spring), std::sqrt(square + spring)}};
  }

  std::complex<double> VoltageDrive::motional_admittance(const WaveLoad &load,
                                                         const double at_frequency) const
  {
    const std::complex<double> needed(
        modal_mass.value * (detuned_square(load) - at_frequency * at_frequency), damper(load));
    return std::complex<double>(0., at_frequency) * force_factor.value * force_factor.value /
           needed;
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
    for (const Estimate &number : {force_factor, modal_mass, natural_frequency, internal_loss})
      text << " " << number.value << " " << number.error();
    text << " " << rotor_loss_factor << "\n";
    return text.str();
  }
} // namespace ringmotor
