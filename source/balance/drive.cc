// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/balance/drive.h>
#include <ringmotor/motor/rotor_loss.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    Estimate mean(const PerPhase<Estimate> &of_phases)
    {
      return 0.5 * (of_phases[0] + of_phases[1]);
    }

    /** The losses (W) of the fields of a wave inside the ceramic, at an amplitude (m). */
    Estimate loss_of_fields(const DrivenWave &wave, const double amplitude)
    {
      const double omega = 2. * numbers::PI * wave.frequency.value_or(wave.natural_frequency.value),
                   ratio = amplitude / wave.amplitude;
      return 2. * omega * ratio * ratio *
             (wave.dielectric_loss_factor - 2. * wave.piezoelectric_loss_factor) *
             wave.electric_energy;
    }
  } // namespace

  std::vector<Quantity> DrivePoint::quantities() const
  {
    return {{"drive_frequency", units::hertz, frequency},
            {"amplitude", units::amplitude, amplitude},
            {"voltage", units::voltage, voltage},
            {"current", units::current, current},
            {"power_factor", units::one, power_factor},
            {"dielectric_loss", units::power, dielectric_loss},
            {"electrical_input", units::power, electrical_input},
            {"electrical_efficiency", units::one, electrical_efficiency}};
  }

  VoltageDrive voltage_drive(const DrivenWave &wave, const LossBudget &losses,
                             const double amplitude, const double voltage)
  {
    VoltageDrive drive;
    drive.voltage = voltage;
    if (wave.frequency)
      drive.frequency = 2. * numbers::PI * *wave.frequency;
    drive.force_factor      = mean(wave.force_factor);
    drive.modal_mass        = wave.modal_mass;
    drive.natural_frequency = 2. * numbers::PI * wave.natural_frequency;
    drive.internal_loss =
        (losses.of_wave() + loss_of_fields(wave, amplitude)) / (amplitude * amplitude);
    return drive;
  }

  void add_voltage_drive(StatorWave &wave, const DrivenWave &driven, const WaveEnergies &energies,
                         const Parameters &parameters)
  {
    if (driven.standing_part > DrivenWave::negligible)
      throw UserError(
          "Electrodes/Distance of phases = " + short_text(parameters.electrodes.phase_distance) +
          ": voltages a quarter of a period apart then drive a wave that is partly standing (" +
          short_text(100. * driven.standing_part) +
          " %), which Wave/Drive = voltage does not compute; allowed: a distance of a quarter of "
          "a wavelength, as 0.25 or 0.75, or Wave/Drive = amplitude");
    CurvePoint at_rest; // with the wave alone
    at_rest.result.amplitude       = driven.amplitude;
    const RotorLossFactor of_rotor = rotor_loss_by_part(parameters);
    const LossBudget losses =
        loss_budget(at_rest, energies, parameters.materials, of_rotor, parameters.support);
    VoltageDrive drive = voltage_drive(driven, losses, driven.amplitude, *parameters.wave.voltage);
    drive.rotor_loss_factor = of_rotor.sum();
    drive.force_factor.errors[causes::wave] += // it is the mean of both phases
        0.5 * difference_of_phases(driven) * std::abs(drive.force_factor.value);
    wave.drive = drive;
  }

  DrivePoint drive_point(const CurvePoint &point, const LossBudget &budget, const DrivenWave &wave)
  {
    const OperatingPoint &result = point.result;
    const Estimate eta = mean(wave.force_factor), c0 = mean(wave.parallel_capacitance),
                   a = budget.amplitude, of_phases = eta.relative() * wave.modal_mass.relative(),
                   // It is as uncertain as the friction loss, which comes from the same forces.
        detuning = result.detuning * (budget.friction.relative() * a.relative());
    DrivePoint drive;
    drive.frequency    = wave.frequency
                             ? Estimate(*wave.frequency)
                             : wave.natural_frequency + wave.natural_frequency.value * detuning;
    drive.amplitude    = a;
    const double omega = 2. * numbers::PI * drive.frequency.value;

    // What the contact takes, with the rotor's damping as the budget has it
    const Estimate of_fields   = loss_of_fields(wave, a.value);
    const double by_contact    = result.taken_from_wave(budget.rotor.value);
    const Estimate power_error = (budget.input() + of_fields).deviation();
    // Force over displacement of one standing wave
    const VoltageDrive balance = voltage_drive(wave, budget, a.value, 1.);
    const WaveLoad load{a.value, omega, result.detuning, by_contact};
    const Complex stiffness = balance.stiffness(load);
    const Estimate spring   = balance.spring(load, detuning),
                   damper   = power_error / (omega * a.value * a.value) +
                            stiffness.imag() * (a * a).relative(),
                   stiffness_error = spring.deviation() + damper.deviation(),
                   angle_error =
                       (spring.value * damper.deviation() + damper.value * spring.deviation()) /
                       std::norm(stiffness);

    const double needed    = std::abs(stiffness) * a.value / eta.value;
    drive.voltage          = wave.voltage
                                 ? Estimate(*wave.voltage)
                                 : needed * (1. + stiffness_error / std::abs(stiffness)) * of_phases;
    drive.voltage_mismatch = std::abs(needed / drive.voltage.value - 1.);
    // Currents and powers are those at the voltage that the state needs, which balance. How far it
    // is from the given one counts in the error of the amplitude, see balanced().
    const Complex motional = eta.value * Complex(0., omega) * (eta.value * needed / stiffness),
                  parallel = Complex(0., omega) * c0.value *
                             Complex(1., -wave.dielectric_loss_factor) * needed,
                  current = motional + parallel;
    drive.current         = std::abs(current) +
                    std::abs(motional) * (of_phases * a.relative() + angle_error).deviation() +
                    std::abs(parallel) * (c0.relative() * drive.voltage.relative()).deviation();
    drive.dielectric_loss =
        parallel.real() * needed * (c0.relative() * (drive.voltage * drive.voltage).relative()) +
        of_fields;
    drive.electrical_input =
        current.real() * needed + power_error + drive.dielectric_loss.deviation();
    const double input = drive.electrical_input.value;
    drive.power_factor =
        input / (std::abs(current) * needed) *
        (drive.electrical_input.relative() * drive.current.relative() * drive.voltage.relative());
    drive.electrical_efficiency = budget.output / drive.electrical_input;
    if (budget.output.value <= 0. || input <= 0.)
      drive.electrical_efficiency.value = 0.;
    // What the contact leaves open is small against the power that it exchanges with the wave, see
    // OperatingPoint::power_imbalance(), which without load is more than the input.
    drive.imbalance = std::abs(input - budget.input().value - drive.dielectric_loss.value) /
                      std::max(std::abs(input), result.gross_power);
    return drive;
  }

  double difference_of_phases(const DrivenWave &wave)
  {
    return std::abs(wave.force_factor[0].value - wave.force_factor[1].value) /
           mean(wave.force_factor).value;
  }
} // namespace ringmotor
