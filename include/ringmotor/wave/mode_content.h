// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/wave/motion_samples.h>

#include <string>

namespace ringmotor
{
  /** The dominant motion of the ring's cross-section in a mode. */
  enum class Family
  {
    out_of_plane, ///< the cross-section moves along the axis: bending out of the ring's plane
    in_plane,     ///< it moves radially and along the ring
    torsion,      ///< it rotates about the ring's centre line
    cross_section ///< it deforms
  };

  std::string to_string(const Family family);

  /**
   * The kinetic energy of a mode, split into rigid motions of the cross-section (axial shift with
   * the tilt of bending; radial and tangential shift with the rotation about the axis; torsion) and
   * the remainder. The fractions add up to 1.
   */
  struct ModeContent
  {
    double axial = 0., in_plane = 0., torsion = 0., cross_section = 0.;
    unsigned int nodal_circles =
        0; ///< sign changes of the axial motion from the inner to the outer side

    /** The kind of motion with the largest fraction. */
    Family family() const;
  };

  /** From the shares of the kinetic energy of the motions of CrossSections, orthonormalised in
   * their order; without nodal circles. */
  ModeContent content_of(const std::array<double, CrossSections::n_motions> &shares);

  /** Classifies @p mode, whatever its place in the spectrum. */
  ModeContent mode_content(const CyclicSector &sector, const Mode &mode);
} // namespace ringmotor
