// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/pictures/ring_body.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** A scalar or a vector at the points of a body. */
  struct PointField
  {
    std::string name, unit;
    unsigned int n_components;
    std::vector<float> values; ///< components of a point one after the other
  };

  /**
   * Writes a body as a VTU file of hexahedra. Cells share their points, which takes an eighth of
   * the space that deal.II's own writer needs; arrays are compressed.
   * @throw UserError if writing fails
   */
  void write_body(const std::string &path, const RingBody &body,
                  const std::vector<PointField> &fields);
} // namespace ringmotor
