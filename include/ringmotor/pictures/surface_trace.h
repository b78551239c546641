// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/modes.h>

#include <array>
#include <complex>
#include <vector>

namespace ringmotor
{
  /** The surfaces of the stator's sector that other programs need. */
  enum class Surface
  {
    tooth_top,  ///< what can touch the rotor
    tooth_foot, ///< the section between base and tooth
    bottom      ///< the lower side, which rests on the felt
  };

  /**
   * The displacement of a wave on a surface of one whole sector, face by face on a lattice that
   * determines the finite-element function there.
   */
  struct SurfaceTrace
  {
    unsigned int order  = 0; ///< subdivisions of a face per direction
    std::size_t n_faces = 0;
    std::vector<dealii::Point<3>> points; ///< m; n_faces * (order + 1)^2, first index fastest
    std::vector<std::array<std::complex<double>, 3>>
        displacement; ///< m; r, theta, z components at these points
  };

  /** Samples @p mode on @p surface; a half sector is completed by its mirror image. */
  SurfaceTrace surface_trace(const CyclicSector &sector, const Mode &mode, const Surface surface);
} // namespace ringmotor
