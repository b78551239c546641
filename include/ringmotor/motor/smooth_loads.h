// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_surface.h>
#include <ringmotor/structure/cyclic_sector.h>

#include <vector>

namespace ringmotor
{
  /** Polynomials of these degrees across a surface (r) and around the ring (theta). */
  struct LoadDegrees
  {
    unsigned int across, around;
    bool vanish_at_cut = false; ///< where sectors meet
  };

  /**
   * Loads on the surface of a half sector in all three directions that span smooth forces on the
   * whole sector's, on the unknowns of nodal diameter @p k. They have the symmetry of motions,
   * U(-theta) = S conj(U(theta)).
   */
  std::vector<std::vector<double>> smooth_loads(const CyclicSector &sector,
                                                const ContactSurface &surface, const unsigned int k,
                                                const LoadDegrees &degrees);

  /** Polynomials up to this degree across the surface in all three directions, where it meets the
   * half plane theta = 0: the loads by which waves of RevolvedModes are excited. */
  std::vector<LinearForm> smooth_loads_in_section(const ContactSurface &surface,
                                                  const unsigned int degree);
} // namespace ringmotor
