// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/balance/loss_budget.h>
#include <ringmotor/motor/condensed_motor.h>

#include <map>
#include <string>

namespace ringmotor
{
  /** The wave of a stator on one mesh, however accurate that is, so that stators of almost the same
   * dimensions have the same error. */
  struct StatorOnMesh
  {
    StatorWave wave;
    WaveEnergies energies;         ///< without that of the felt
    WaveMotion bottom;             ///< of the lower side, with the amplitude of the energies
    double natural_frequency = 0.; ///< Hz, of its mode
    unsigned int n_dofs      = 0;  ///< of the mesh

    /** The energies with that of a felt, of which the wave need not feel anything. */
    WaveEnergies energies_on(const Parameters &parameters) const;
    /** The same with its wave at another amplitude (m). */
    StatorOnMesh at(const double amplitude) const;
  };

  /** The parameters with the stator's effects that are `auto` switched on or off, as the program
   * `stator` does. */
  Parameters with_stator_effects(const Parameters &parameters);

  /** @param parameters without stator's effects that are `auto`
   * @throws UserError for bodies that have no mesh
   * @throws ComputationError if the motor's wave is not among the modes */
  StatorOnMesh stator_on_mesh(const Parameters &parameters);

  /** Stators of motors that differ little from a first one, each computed once. */
  class NearbyStators
  {
  public:
    /** See with_stator_effects(). */
    explicit NearbyStators(const Parameters &parameters);

    /** The first motor, without stator's effects that are `auto`, and its stator. */
    const Parameters &parameters() const { return first; }
    const StatorOnMesh &stator() const { return of_first; }

    /** That of another motor. See stator_on_mesh(); @throws ComputationError also if its mesh has
     * other cells than the first one */
    StatorOnMesh of(const Parameters &other) const;

  private:
    const Parameters first;
    const StatorOnMesh of_first;
    mutable std::map<std::string, StatorOnMesh> known; ///< by what their waves depend on
  };
} // namespace ringmotor
