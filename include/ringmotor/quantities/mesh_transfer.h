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
    /** Both motors must outlive this object. */
    MeshTransfer(const CondensedMotor &from, const CondensedMotor &to);
    ContactFields fields(const ContactFields &known) const;

  private:
    const CondensedMotor &from, &to;
    std::vector<std::vector<unsigned int>> sources; ///< nearest to each point of the new mesh
    /** Those by which a field is interpolated to each point of the new mesh, with their weights. */
    std::vector<std::vector<std::pair<unsigned int, double>>> weights;
    std::vector<unsigned int> target; ///< nearest to each point of the old mesh
  };
} // namespace ringmotor
