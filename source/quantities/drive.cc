// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/quantities/drive.h>

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
            quantity("voltage", units::voltage, voltage),
            quantity("current", units::current, current),
            quantity("power_factor", units::one, power_factor),
            quantity("dielectric_loss", units::power, dielectric_loss),
            quantity("electrical_input", units::power, electrical_input),
            quantity("electrical_efficiency", units::one, electrical_efficiency)};
  }

  DrivePoint drive_point(const CurvePoint &point, const LossBudget &budget, const DrivenWave &wave,
                         const std::optional<double> &frequency)
  {
    const OperatingPoint &result = point.result;
    const Estimate eta = mean(wave.force_factor), c0 = mean(wave.parallel_capacitance);
    const double a = wave.amplitude, m = wave.modal_mass.value,
                 of_phases = relative_error(eta) + relative_error(wave.modal_mass);
    // The detuning is as uncertain as the friction loss, which comes from the same forces.
    const double detuning_error = std::abs(result.detuning) * relative_error(budget.friction);
    DrivePoint drive;
    drive.frequency    = frequency ? Estimate{*frequency, 0.}
                                   : Estimate{wave.natural_frequency.value * (1. + result.detuning),
                                           wave.natural_frequency.error +
                                               wave.natural_frequency.value * detuning_error};
    const double omega = 2. * numbers::PI * drive.frequency.value;

    // What the contact takes, with the rotor's damping as the budget has it, and the stator's
    // losses
    const double of_fields = 2. * omega * wave.electric_energy.value *
                             (wave.dielectric_loss_factor - 2. * wave.piezoelectric_loss_factor);
    const double mechanical = result.input_power - result.modal_damping + budget.rotor.value +
                              budget.stator().value + budget.support.value + of_fields;
    const double power_error =
        budget.input().error + relative_error(wave.electric_energy) * std::abs(of_fields);
    // Force over displacement of one standing wave; a drive that follows the resonance feels no
    // spring. Errors are bounds and add up.
    const double omega_r_square = std::pow(2. * numbers::PI * wave.natural_frequency.value, 2),
                 spring         = frequency
                                      ? m * (omega_r_square * (1. + 2. * result.detuning) - omega * omega)
                                      : 0.,
                 damper         = mechanical / (omega * a * a);
    const double spring_error =
        frequency
            ? 2. * m * omega_r_square * (relative_error(wave.natural_frequency) + detuning_error) +
                  std::abs(spring) * relative_error(wave.modal_mass)
            : 0.;
    const Complex stiffness(spring, damper);
    const double damper_error    = power_error / (omega * a * a),
                 stiffness_error = spring_error + damper_error,
                 angle_error = (std::abs(damper) * spring_error + std::abs(spring) * damper_error) /
                               std::norm(stiffness);

    const double voltage = std::abs(stiffness) * a / eta.value;
    drive.voltage        = {voltage, voltage * (stiffness_error / std::abs(stiffness) + of_phases)};
    const Complex motional = eta.value * Complex(0., omega) * (eta.value * voltage / stiffness),
                  parallel = Complex(0., omega) * c0.value *
                             Complex(1., -wave.dielectric_loss_factor) * voltage,
                  current = motional + parallel;
    const double current_error =
        std::abs(motional) * (of_phases + angle_error) +
        std::abs(parallel) * (relative_error(c0) + relative_error(drive.voltage));
    drive.current          = {std::abs(current), current_error};
    const double of_c0     = parallel.real() * voltage; // of both phases
    drive.dielectric_loss  = {of_c0 + of_fields,
                              of_c0 * (relative_error(c0) + 2. * relative_error(drive.voltage)) +
                                  std::abs(of_fields) * relative_error(wave.electric_energy)};
    drive.electrical_input = {current.real() * voltage, power_error + drive.dielectric_loss.error};
    const double factor    = drive.electrical_input.value / (std::abs(current) * voltage);
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
                  const DrivenWave &wave, const std::optional<double> &frequency)
  {
    LossBudget known_budget = budgets.front().second;
    for (Estimate LossBudget::*const part :
         {&LossBudget::output, &LossBudget::friction, &LossBudget::stator_metal,
          &LossBudget::piezoceramic, &LossBudget::rotor, &LossBudget::support})
      (known_budget.*part).error = 0.;
    DrivenWave known_wave = wave;
    for (Estimate DrivenWave::*const part :
         {&DrivenWave::natural_frequency, &DrivenWave::modal_mass, &DrivenWave::electric_energy})
      (known_wave.*part).error = 0.;
    for (PerPhase<Estimate> DrivenWave::*const part :
         {&DrivenWave::force_factor, &DrivenWave::parallel_capacitance})
      for (Estimate &of_phase : known_wave.*part)
        of_phase.error = 0.;

    std::vector<std::pair<std::string, DrivePoint>> drives{
        {"circuits of the phases", drive_point(point, known_budget, wave, frequency)}};
    for (const auto &[cause, budget] : budgets)
      drives.emplace_back(cause, drive_point(point, budget, known_wave, frequency));
    return drives;
  }

  double difference_of_phases(const DrivenWave &wave)
  {
    return std::abs(wave.force_factor[0].value - wave.force_factor[1].value) /
           mean(wave.force_factor).value;
  }
} // namespace ringmotor
