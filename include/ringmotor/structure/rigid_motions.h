// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/cyclic_sector.h>

namespace ringmotor
{
  /**
   * An eigenvalue in 1/s^2 far below those of the elastic modes, and far above the rounding errors
   * of rigid motions: that of waves a thousand times longer than the body.
   */
  double slow_eigenvalue(const CyclicSector &sector);

  /**
   * The rigid motions that a wave of nodal diameter @p k contains and that neither bars nor clamped
   * faces constrain, as unknowns of @p sector: from axial shift and spin for k = 0, in-plane shift
   * and tilt for k = 1, none otherwise. M-orthonormal.
   */
  std::vector<std::vector<double>> rigid_motions(const CyclicSector &sector, const unsigned int k);

  /**
   * The fraction (0 to 1) of the kinetic energy of the M-normalised @p unknowns that lies in the
   * space of @p rigid_motions.
   */
  double rigid_fraction(const CyclicSector &sector, const unsigned int k,
                        const std::vector<std::vector<double>> &rigid_motions,
                        const std::vector<double> &unknowns);
} // namespace ringmotor
