// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/mesh_file.h>
#include <ringmotor/mesh/section.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /**
   * Checks that the cells of a section make up one body: away from the axis and of plausible size,
   * connected along whole edges, without cells on one another.
   * @throws UserError that refuses the @p file
   */
  void check_body(const Section &section, const MeshFile &file);

  /**
   * Checks the teeth of a stator's section, if it has any: they stand on the base on one line, and
   * their tops are one line named `contact`, the highest of the section.
   * @throws UserError that refuses the @p file
   */
  void check_teeth(const Section &section, const MeshFile &file);

  /** Whether edges make up one line with two ends. */
  bool is_one_line(const std::vector<Section::Edge> &edges);

  /** "r = 15 mm, z = 1 mm" */
  std::string in_words(const dealii::Point<2> &place);
} // namespace ringmotor
