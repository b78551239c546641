// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/quantities/loss_budget.h>
#include <ringmotor/quantities/phase_circuit.h>

#include <optional>

namespace ringmotor
{
  /** A travelling wave with the electrodes that drive it. */
  struct DrivenWave
  {
    double amplitude = 0.;      ///< m, at the outer edge of the tooth tops
    Estimate natural_frequency; ///< Hz, at short circuit and without rotor
    Estimate modal_mass;        ///< kg, of each of its two standing waves
    Estimate electric_energy;   ///< J, of the fields of the wave inside the ceramic, both waves
    PerPhase<Estimate> force_factor, parallel_capacitance; ///< N/V and F, see PhaseCircuit
    double dielectric_loss_factor = 0., piezoelectric_loss_factor = 0.;
  };

  /**
   * What the phases of a motor need at an operating point: equal voltages a quarter of a period
   * apart, each of which drives one standing wave,
   *
   *     eta V = |m (omega_r^2 (1 + 2 delta) - omega^2) a + i P / (omega a)|,
   *
   * with the wave's amplitude a, modal mass m, force factor eta, the relative detuning delta by the
   * contact, and the mechanical power P: what the contact takes, see OperatingPoint::input_power,
   * and the internal losses of stator and felt.
   */
  struct DrivePoint
  {
    Estimate frequency;             ///< Hz
    Estimate voltage;               ///< V, zero to peak, of each phase
    Estimate current;               ///< A, zero to peak, of each phase
    Estimate power_factor;          ///< real over apparent power
    Estimate dielectric_loss;       ///< W, of both phases
    Estimate electrical_input;      ///< W, of both phases
    Estimate electrical_efficiency; ///< output over that
    double imbalance = 0.; ///< electrical input less output and all losses, relative to the input

    /** For all outputs. */
    std::vector<Quantity> quantities() const;
  };

  /** @param frequency (Hz) of the drive; none: that of the wave with the rotor on the stator */
  DrivePoint drive_point(const CurvePoint &point, const LossBudget &budget, const DrivenWave &wave,
                         const std::optional<double> &frequency);

  /** The same, each with the errors of one cause alone, those of budgets_by_cause() and those of
   * the circuits; these add up to the total error. */
  std::vector<std::pair<std::string, DrivePoint>>
  drives_by_cause(const CurvePoint &point,
                  const std::vector<std::pair<std::string, LossBudget>> &budgets,
                  const DrivenWave &wave, const std::optional<double> &frequency);

  /** The relative difference of the force factors of both phases. Above a percent or so they need
   * different voltages, and drive_point() gives their mean. */
  double difference_of_phases(const DrivenWave &wave);
} // namespace ringmotor
