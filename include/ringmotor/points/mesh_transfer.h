// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/marching.h>
#include <ringmotor/points/contact_fields.h>

#include <utility>
#include <vector>

namespace ringmotor
{
  /**
   * Transfers states from the contact nodes of one mesh to those of another mesh of the same motor,
   * as initial guesses. Forces go to the surrounding closed nodes in proportion to their areas,
   * which preserves their sum; gaps are interpolated; slips and status are those of the nearest
   * node. Displacements are left out.
   */
  class MeshTransfer
  {
  public:
    using Weights = std::vector<std::pair<unsigned int, double>>; ///< by node

    MeshTransfer(const CondensedMotor &from, const CondensedMotor &to);
    ContactFields fields(const ContactFields &known) const;
    /** With the same modes. */
    MarchedState marched(const MarchedState &known) const;

  private:
    /** Forces, motions and status; everything else remains. */
    void transfer(const StepState &known, StepState &result) const;

    std::vector<unsigned int> source; ///< nearest to each node of the new mesh
    /** Those by which a field is interpolated to each node of the new mesh. */
    std::vector<Weights> weights;
    std::vector<unsigned int> target; ///< nearest to each node of the old mesh
    /** Nodes of the new mesh around each node of the old one, with the areas (m^2) by which they
     * share its force. */
    std::vector<Weights> around;
  };
} // namespace ringmotor
