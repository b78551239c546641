// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace ringmotor
{
  /** The section of a shell across its reference surface, the one that is meshed. */
  struct ShellSection
  {
    double thickness = 0.; ///< m
    double offset =
        0.; ///< m, from the reference surface to the mid-surface, along the cells' normals

    /** Heights (m) of the faces over the reference surface, along the cells' normals. */
    double lower_face() const { return offset - 0.5 * thickness; }
    double upper_face() const { return offset + 0.5 * thickness; }
  };

  /** A bar along an edge of solid cells. */
  struct BarSection
  {
    double axial_stiffness = 0.; ///< E A, N
    double mass_per_length = 0.; ///< kg/m
  };
} // namespace ringmotor
