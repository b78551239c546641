// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/modes.h>

#include <array>
#include <complex>
#include <vector>

namespace ringmotor
{
  /** Motion at a quadrature point. For a nodal diameter k the wave's phase is removed: then it is
   * nearly constant around the ring. */
  struct MotionSample
  {
    double r, theta, z;                         ///< m, rad, m
    double mass;                                ///< kg
    std::array<std::complex<double>, 3> motion; ///< r, theta, z components times exp(i k theta)
  };

  /** Those of a mode on a whole sector, or on a whole ring. */
  std::vector<MotionSample> motion_samples(const CyclicSector &sector, const Mode &mode);

  /** Sign changes, along the radius, of the axial motion that is in phase with its largest value.
   */
  unsigned int count_nodal_circles(const std::vector<MotionSample> &samples);
} // namespace ringmotor
