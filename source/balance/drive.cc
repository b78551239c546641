// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/balance/drive.h>

#include <cmath>
#include <complex>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    double relative_error(const Estimate &estimate)
    {
      return estimate.value == 0. ? 0. : estimate.error / std::abs(estimate.value);
    }

    Estimate mean(const PerPhase<Estimate> &of_phases)
    {
      return {0.5 * (of_phases[0].value + of_phases[1].value),
              0.5 * (of_phases[0].error + of_phases[1].error)};
    }
  } // namespace

  std::vector<Quantity> DrivePoint::quantities() const
  {
    const auto quantity = [](const std::string &name, const Unit &unit, const Estimate &estimate) {
      return Quantity{name, unit, estimate.value, estimate.error};
    };
    return {quantity("drive_frequency", units::hertz, frequency),
            quantity("amplitude", units::amplitude, amplitude),
            quantity("voltage", units::voltage, voltage),
            quantity("current", units::current, current),
            quantity("power_factor", units::one, power_factor),
            quantity("dielectric_loss", units::power, dielectric_loss),
            quantity("electrical_input", units::power, electrical_input),
            quantity("electrical_efficiency", units::one, electrical_efficiency)};
  }

  namespace
  {
    /** The losses (W) of the fields of a wave inside the ceramic, at an amplitude (m). */
    Estimate loss_of_fields(const DrivenWave &wave, const double amplitude)
    {
      const double omega = 2. * numbers::PI * wave.frequency.value_or(wave.natural_frequency.value),
                   ratio = amplitude / wave.amplitude,
                   value = 2. * omega * ratio * ratio * wave.electric_energy.value *
                           (wave.dielectric_loss_factor - 2. * wave.piezoelectric_loss_factor);
      return {value, std::abs(value) * relative_error(wave.electric_energy)};
    }
  } // namespace

  VoltageDrive voltage_drive(const DrivenWave &wave, const LossBudget &losses,
                             const double amplitude, const double voltage)
  {
    const Estimate eta = mean(wave.force_factor), fields = loss_of_fields(wave, amplitude),
                   stator = losses.stator();
    VoltageDrive drive;
    drive.voltage = voltage;
    if (wave.frequency)
      drive.frequency = 2. * numbers::PI * *wave.frequency;
    drive.force_factor      = eta.value;
    drive.modal_mass        = wave.modal_mass.value;
    drive.natural_frequency = 2. * numbers::PI * wave.natural_frequency.value;
    drive.internal_loss =
        (stator.value + losses.support.value + fields.value) / (amplitude * amplitude);
    drive.force_factor_error      = relative_error(eta);
    drive.modal_mass_error        = relative_error(wave.modal_mass);
    drive.natural_frequency_error = relative_error(wave.natural_frequency);
    drive.internal_loss_error =
        (stator.error + losses.support.error + fields.error) / (amplitude * amplitude);
    return drive;
  }

  DrivePoint drive_point(const CurvePoint &point, const LossBudget &budget, const DrivenWave &wave)
  {
    const OperatingPoint &result = point.result;
    const Estimate eta = mean(wave.force_factor), c0 = mean(wave.parallel_capacitance);
    const double a = budget.amplitude.value, amplitude_error = relative_error(budget.amplitude),
                 of_phases = relative_error(eta) + relative_error(wave.modal_mass);
    // The detuning is as uncertain as the friction loss, which comes from the same forces.
    const double detuning_error =
        std::abs(result.detuning) * (relative_error(budget.friction) + amplitude_error);
    DrivePoint drive;
    drive.frequency    = wave.frequency
                             ? Estimate{*wave.frequency, 0.}
                             : Estimate{wave.natural_frequency.value * (1. + result.detuning),
                                     wave.natural_frequency.error +
                                         wave.natural_frequency.value * detuning_error};
    drive.amplitude    = budget.amplitude;
    const double omega = 2. * numbers::PI * drive.frequency.value;

    // What the contact takes, with the rotor's damping as the budget has it
    const Estimate of_fields = loss_of_fields(wave, a);
    const double by_contact  = result.taken_from_wave(budget.rotor.value),
                 power_error = budget.input().error + of_fields.error;
    // Force over displacement of one standing wave. Errors are bounds and add up.
    const VoltageDrive balance = voltage_drive(wave, budget, a, 1.);
    const Complex stiffness    = balance.stiffness({a, omega, result.detuning, by_contact});
    const double spring = std::abs(stiffness.real()), damper = std::abs(stiffness.imag()),
                 spring_error    = balance.spring_error(spring, detuning_error),
                 damper_error    = power_error / (omega * a * a) + 2. * amplitude_error * damper,
                 stiffness_error = spring_error + damper_error,
                 angle_error =
                     (damper * spring_error + spring * damper_error) / std::norm(stiffness);

    const double needed = std::abs(stiffness) * a / eta.value;
    drive.voltage =
        wave.voltage
            ? Estimate{*wave.voltage, 0.}
            : Estimate{needed, needed * (stiffness_error / std::abs(stiffness) + of_phases)};
    drive.voltage_mismatch = std::abs(needed / drive.voltage.value - 1.);
    // Currents and powers are those at the voltage that the state needs, which balance. How far it
    // is from the given one counts in the error of the amplitude, see balanced_amplitude().
    const Complex motional = eta.value * Complex(0., omega) * (eta.value * needed / stiffness),
                  parallel = Complex(0., omega) * c0.value *
                             Complex(1., -wave.dielectric_loss_factor) * needed,
                  current = motional + parallel;
    const double current_error =
        std::abs(motional) * (of_phases + angle_error + amplitude_error) +
        std::abs(parallel) * (relative_error(c0) + relative_error(drive.voltage));
    drive.current          = {std::abs(current), current_error};
    const double of_c0     = parallel.real() * needed; // of both phases
    drive.dielectric_loss  = {of_c0 + of_fields.value,
                              of_c0 * (relative_error(c0) + 2. * relative_error(drive.voltage)) +
                                  of_fields.error};
    drive.electrical_input = {current.real() * needed, power_error + drive.dielectric_loss.error};
    const double factor    = drive.electrical_input.value / (std::abs(current) * needed);
    drive.power_factor     = {factor, std::abs(factor) * (relative_error(drive.electrical_input) +
                                                      relative_error(drive.current) +
                                                      relative_error(drive.voltage))};
    const double input = drive.electrical_input.value, efficiency = budget.output.value / input;
    drive.electrical_efficiency = {budget.output.value > 0. && input > 0. ? efficiency : 0.,
                                   budget.output.error / std::abs(input) +
                                       std::abs(efficiency) *
                                           relative_error(drive.electrical_input)};
    drive.imbalance =
        std::abs(input - budget.input().value - drive.dielectric_loss.value) / std::abs(input);
    return drive;
  }

  std::vector<std::pair<std::string, DrivePoint>>
  drives_by_cause(const CurvePoint &point,
                  const std::vector<std::pair<std::string, LossBudget>> &budgets,
                  const DrivenWave &wave)
  {
    DrivenWave known_wave = wave;
    for (Estimate DrivenWave::*const part :
         {&DrivenWave::natural_frequency, &DrivenWave::modal_mass, &DrivenWave::electric_energy})
      (known_wave.*part).error = 0.;
    for (PerPhase<Estimate> DrivenWave::*const part :
         {&DrivenWave::force_factor, &DrivenWave::parallel_capacitance})
      for (Estimate &of_phase : known_wave.*part)
        of_phase.error = 0.;

    std::vector<std::pair<std::string, DrivePoint>> drives;
    for (const auto &[cause, budget] : budgets)
      drives.emplace_back(
          cause, drive_point(point, budget, cause == PointErrors::by_circuits ? wave : known_wave));
    return drives;
  }

  double difference_of_phases(const DrivenWave &wave)
  {
    return std::abs(wave.force_factor[0].value - wave.force_factor[1].value) /
           mean(wave.force_factor).value;
  }
} // namespace ringmotor
