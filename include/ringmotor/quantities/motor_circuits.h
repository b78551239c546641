// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>
#include <ringmotor/quantities/motor_wave.h>
#include <ringmotor/quantities/phase_circuit.h>

#include <array>
#include <optional>

namespace ringmotor
{
  /** The equivalent circuits of the phases of a motor, and which waves its electrodes excite. */
  class MotorCircuits
  {
  public:
    explicit MotorCircuits(const Parameters &parameters);

    /** Adds the results of one mesh; error bars come from their change to the next mesh. */
    void add_pass(const ModeSearch &search, const WaveResult &wave);

    struct PhaseResult
    {
      Phase phase;
      PhaseCircuit circuit;
      std::vector<Quantity> quantities; ///< without errors after the first mesh
    };
    /** Empty before the first pass. */
    const std::vector<PhaseResult> &results() const { return of_phases; }

    /** The share of a nodal diameter in what the electrodes of both phases excite: |V_n| over the
     * largest one of all. */
    double excitation(const unsigned int n) const;

  private:
    const ElectrodeLayout layout;
    const Piezoelectricity losses;
    std::vector<PhaseResult> of_phases;
    std::optional<FrequencySample> earlier_frequency;
  };
} // namespace ringmotor
