// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/vtu_file.h>
#include <ringmotor/pictures/ring_body.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** Writes a body as a VTU file of hexahedra, which share their points.
   * @throw UserError if writing fails */
  void write_body(const std::string &path, const RingBody &body,
                  const std::vector<PointField> &fields);
} // namespace ringmotor
