// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/section.h>

namespace ringmotor
{
  /**
   * The section without the lines that begin at an inner point of the edges with this name and only
   * divide cells: those on which no part, name or direction changes. Cells on both sides of such a
   * line, through to the other end, become one. Whoever cuts the edges anew needs none of the cuts
   * of a file.
   */
  Section without_lines_from(const dealii::types::boundary_id name, const Section &section);
} // namespace ringmotor
