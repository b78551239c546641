// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/section.h>

#include <vector>

namespace ringmotor
{
  /** The shape of a face in contact as it is drawn, such as a crown or a cone. */
  struct FaceProfile
  {
    /** (r, z) in m, by ascending radius, linear in between; empty: level. */
    std::vector<dealii::Point<2>> points;

    /** m, above the first point; constant beyond both ends. */
    double height(const double radius) const;
    /** m, from the lowest to the highest point. */
    double depth() const;
  };

  /** The profile of the edges of a section with this name. @p section has them in one line. */
  FaceProfile face_profile(const Section &section, const dealii::types::boundary_id contact);

  /** The largest depth of a profile over its width that is a gap between faces that are level in
   * the mesh; a deeper one is a shape of the body. */
  constexpr double most_depth_of_profile = 0.1;

  /** The section with a level line instead of a profile that is not deeper than that, at its mean
   * height. */
  Section levelled(Section section, const dealii::types::boundary_id contact,
                   const FaceProfile &profile);
} // namespace ringmotor
