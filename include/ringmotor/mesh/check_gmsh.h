// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <istream>

namespace ringmotor
{
  /**
   * Whether a file is a mesh in Gmsh's ASCII format of version 1, 2.2 or 4.1 whose sections have
   * the lines that they announce, each with as many numbers as it should have, and whose elements
   * join nodes of the file. deal.II trusts all these numbers.
   */
  bool is_whole_gmsh(std::istream &input);
} // namespace ringmotor
