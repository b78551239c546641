// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sector_elements.h>

#include <map>
#include <vector>

namespace ringmotor
{
  /** Quadratic forms of a complex motion U on the meshed part of a sector, summed over real and
   * imaginary part. */
  struct MotionProducts
  {
    std::map<dealii::types::material_id, double>
        stiffness;             ///< U.K U in N m, by the material of solids and shells
    ElectricProducts electric; ///< of piezoelectric solids, with the potential of the motion
    std::map<dealii::types::boundary_id, double>
        stiffness_of_supports; ///< of bars and foundations, by the id of their edges and faces
    double mass = 0.;          ///< U.M U in kg m^2

    /** U.K U of all parts, and in piezoelectric ones 2 U.B phi - phi.D phi: what resists a motion
     * whose potential is in equilibrium. */
    double total_stiffness() const;
  };

  /**
   * The products of each of @p motions, summed over all ranks. They come from strains and motions
   * at quadrature points, so a large rigid motion does not blur small strains, as it would in
   * assembled matrices.
   */
  std::vector<MotionProducts> motion_products(const SectorElements &elements,
                                              const std::vector<const SectorMotion *> &motions);
} // namespace ringmotor
