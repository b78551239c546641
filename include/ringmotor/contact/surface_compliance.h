// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/condensation/interface_compliance.h>
#include <ringmotor/contact/contact_surface.h>

#include <array>
#include <complex>
#include <vector>

namespace ringmotor
{
  /**
   * The compliance of the nodes of a surface over a whole sector (m/N, three cylindrical components
   * for each node). For a wave with nodal diameter k, motions and forces of sector j are exp(-i k j
   * alpha) times those of sector 0, and the compliance is
   *
   *   at_rest + shapes D B_k D^H shapes^T
   *
   * with B_k as InterfaceCompliance::through_cut() gives it; D is 1 for shapes of the real field,
   * which come first, and i for those of the imaginary one.
   */
  struct SurfaceCompliance
  {
    dealii::FullMatrix<double> at_rest; ///< with the cuts at rest
    dealii::FullMatrix<double> shapes;  ///< one column for each
    unsigned int n_real_shapes = 0;
  };

  /** The compliance of a surface whose nodes come from the meshed part of a sector; its
   * displacements come first in the interface. */
  SurfaceCompliance sector_compliance(const InterfaceCompliance &meshed,
                                      const std::vector<MirroredNode> &origin);

  /** The motion of a half sector's surface (real field, then imaginary one) over the whole sector.
   */
  std::vector<std::array<std::complex<double>, 3>>
  sector_motion(const std::vector<double> &half, const std::vector<MirroredNode> &origin);
} // namespace ringmotor
