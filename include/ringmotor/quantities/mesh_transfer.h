// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/quantities/contact_fields.h>

#include <utility>
#include <vector>

namespace ringmotor
{
  /**
   * Carries states from the contact points of one mesh to those of another mesh of the same motor,
   * as starts. Forces go to the closed points around, in proportion to their areas, so that no
   * force is lost; gaps are interpolated; slips and status are those of the nearest point.
   * Displacements are left out.
   */
  class MeshTransfer
  {
  public:
    using Weights = std::vector<std::pair<unsigned int, double>>; ///< by point

    MeshTransfer(const CondensedMotor &from, const CondensedMotor &to);
    ContactFields fields(const ContactFields &known) const;

  private:
    std::vector<unsigned int> source; ///< nearest to each point of the new mesh
    /** Those by which a field is interpolated to each point of the new mesh. */
    std::vector<Weights> weights;
    std::vector<unsigned int> target; ///< nearest to each point of the old mesh
    /** Points of the new mesh around each point of the old one, with the areas (m^2) by which they
     * share its force. */
    std::vector<Weights> around;
  };
} // namespace ringmotor
