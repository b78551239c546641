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

  /** Twice their kinetic energy at unit frequency. */
  double energy_of(const std::vector<MotionSample> &samples);

  /** Rigid motions of the cross-sections of a body: axial shift and its tilt; radial and tangential
   * shift and the rotation about the axis; torsion. */
  class CrossSections
  {
  public:
    static constexpr unsigned int n_motions = 6;

    /** Finds their centre of mass, about which they rotate. */
    explicit CrossSections(const std::vector<MotionSample> &samples);

    /** The r, theta, z components of each motion at a point. */
    std::array<std::array<double, 3>, n_motions> at(const MotionSample &sample) const;

  private:
    double center_r = 0., center_z = 0.;
  };

  /** Sign changes, along the radius, of the axial motion that is in phase with its largest value.
   */
  unsigned int count_nodal_circles(const std::vector<MotionSample> &samples);
} // namespace ringmotor
