// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/body_origin.h>
#include <ringmotor/mesh/section.h>

#include <string>

namespace ringmotor
{
  /**
   * Reads a cross-section from a Gmsh file (see read_gmsh()): quadrilaterals with x = r, y = z (m);
   * those of second order are split, see with_split_elements(). Physical surfaces are the parts of
   * the body and physical curves its supports, loads, contact and shell, all by name, see
   * meshes/README.md. The root of the shell, which depends on its thickness, has no name yet, see
   * name_shell_root().
   *
   * @throws UserError naming `Stator/Section file` or `Rotor/Section file` for a file that cannot
   * be read, elements that are not quadrilaterals, parts and edges with unknown names or none,
   *         sections that reach the axis, are in other units or in pieces, cells that are not
   * convex or lie on one another, names of edges inside, contact lines that are missing or not a
   *         line that faces the other body, and shells that shell_line() refuses.
   */
  Section read_section(const std::string &file, const BodyOf body);
} // namespace ringmotor
