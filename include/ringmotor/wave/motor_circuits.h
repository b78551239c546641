// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>
#include <ringmotor/wave/motor_wave.h>
#include <ringmotor/wave/phase_circuit.h>

#include <vector>

namespace ringmotor
{
  /**
   * The equivalent circuits of the phases of a motor. Their motional branches follow the wave from
   * mesh to mesh. Capacitances are integral quantities that coarse meshes give accurately, but ask
   * for the response of all nodal diameters: they have two coarse meshes of their own.
   */
  class MotorCircuits
  {
  public:
    explicit MotorCircuits(const Parameters &parameters);

    /** Adds the motional branches on one mesh. */
    void add_pass(const ModeSearch &search, const WaveResult &wave);

    /** Adds the capacitances on one of at least two coarse meshes, the finer one last. @throws
     * ComputationError if the motor's wave is not found on it */
    void add_capacitances(const ModeSearch &search);

    /** The circuit of a phase, from the last meshes. */
    PhaseCircuit circuit(const Phase phase) const;

    const ElectrodeLayout &electrodes() const { return layout; }

    /** Its numbers with their error bars. Requires two passes and two coarse meshes. */
    std::vector<Quantity> quantities(const Phase phase) const;

  private:
    struct Sample
    {
      Estimate frequency;
      FrequencySample quality_of_mesh;
      PerPhase<MotionalBranch> branches;
    };

    const ElectrodeLayout layout;
    const PhaseHarmonics harmonics;
    const Piezoelectricity losses;
    const MaterialTable materials; ///< with their loss factors
    const unsigned int n_waves;
    std::vector<Sample> samples; ///< by pass
    std::vector<PerPhase<ParallelCapacitance>> capacitances;
  };
} // namespace ringmotor
