// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/gmsh_mesh.h>

namespace ringmotor
{
  /**
   * The mesh with quadrilaterals and lines of first order in place of those of second order: each
   * quadrilateral of 8 or 9 nodes becomes four, at the middles of its sides and its centre (for 8
   * nodes that of their shape functions), each line of 3 nodes two. The parts have the physical ids
   * of the whole.
   */
  GmshMesh with_split_elements(GmshMesh mesh);
} // namespace ringmotor
