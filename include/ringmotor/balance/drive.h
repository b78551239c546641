// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/balance/loss_budget.h>
#include <ringmotor/motor/voltage_drive.h>
#include <ringmotor/wave/phase_circuit.h>

#include <optional>

namespace ringmotor
{
  /** A travelling wave with the electrodes that drive it. */
  struct DrivenWave
  {
    double amplitude = 0.; ///< m, at the outer edge of the tooth tops, that of the energy below
    Estimate natural_frequency; ///< Hz, at short circuit and without rotor
    Estimate modal_mass;        ///< kg, of each of its two standing waves
    Estimate electric_energy;   ///< J, of the fields of the wave inside the ceramic, both waves
    PerPhase<Estimate> force_factor, parallel_capacitance; ///< N/V and F, see PhaseCircuit
    double standing_part = 0.;                             ///< see ElectrodeLayout::standing_part()
    /** What may be neglected of it, and of difference_of_phases(). */
    static constexpr double negligible = 0.02;
    double dielectric_loss_factor = 0., piezoelectric_loss_factor = 0.;
    std::optional<double> frequency; ///< Hz, of the drive; none: it follows the resonance
    std::optional<double> voltage;   ///< V, if it is given; none: the amplitude is given
  };

  /** What the phases of a motor need at an operating point: equal voltages a quarter of a period
   * apart, see VoltageDrive. */
  struct DrivePoint
  {
    Estimate frequency;             ///< Hz
    Estimate amplitude;             ///< m, of the wave
    Estimate voltage;               ///< V, zero to peak, of each phase
    Estimate current;               ///< A, zero to peak, of each phase
    Estimate power_factor;          ///< real over apparent power
    Estimate dielectric_loss;       ///< W, of both phases
    Estimate electrical_input;      ///< W, of both phases
    Estimate electrical_efficiency; ///< output over that
    /** How far the voltage that the amplitude needs is from the given one, relative. */
    double voltage_mismatch = 0.;
    double imbalance = 0.; ///< electrical input less output and all losses, relative to the input
                           ///< or the power that the contact exchanges with the wave if larger

    /** For all outputs. */
    std::vector<Quantity> quantities() const;
  };

  /** The drive of a wave.
   *  @param voltage V, zero to peak, of each phase
   *  @param losses of which those of the stator's wave and its felt count, at the amplitude @p
   * amplitude (m) */
  VoltageDrive voltage_drive(const DrivenWave &wave, const LossBudget &losses,
                             const double amplitude, const double voltage);

  /** Adds the drive by the given voltage to a wave.
   * @throws UserError if the electrodes drive a wave that is partly standing */
  void add_voltage_drive(StatorWave &wave, const DrivenWave &driven, const WaveEnergies &energies,
                         const Parameters &parameters);

  DrivePoint drive_point(const CurvePoint &point, const LossBudget &budget, const DrivenWave &wave);

  /** The relative difference of the force factors of both phases. Above a percent or so they need
   * different voltages, and drive_point() gives their mean. */
  double difference_of_phases(const DrivenWave &wave);
} // namespace ringmotor
