// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/mesh_file.h>
#include <ringmotor/mesh/section.h>

#include <vector>

namespace ringmotor
{
  /** A piece of the curve `shell` of a section's file, between two of its nodes. */
  struct ShellPiece
  {
    Section::Edge nodes;
    bool in_contact = false; ///< whether it also has the name `contact`
  };

  /**
   * The line of a shell that is drawn beside the cells of a section: from its free end outwards to
   * an outer edge of the cells. Pieces that continue each other become one.
   * @param places of the nodes
   * @throws UserError that refuses the @p file for curves that branch or are in pieces, that do not
   *         have one end at the body, do not lead outwards, or are in contact elsewhere than from
   *         their free end on or not level there
   */
  Section::ShellLine shell_line(const std::vector<ShellPiece> &pieces,
                                const std::vector<dealii::Point<2>> &places, const Section &section,
                                const MeshFile &file);

  /**
   * Names the outer edges at the end of the section's shell, across it, ids::shell_root.
   * @param thickness m, of the shell
   * @throws UserError that refuses the @p file for edges that have a name or do not cover the
   *         thickness
   */
  void name_shell_root(Section &section, const double thickness, const MeshFile &file);

  /** m, what is thinnest at re-entrant corners of a section with a shell: the shell, or an edge
   * there that does not end at it. */
  double thinnest_with_shell(const Section &section, const double thickness);

  /** The section with cells in place of its shell, as thick as that. */
  Section with_cells_for_shell(Section section, const double thickness);
} // namespace ringmotor
