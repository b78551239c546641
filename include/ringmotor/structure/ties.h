// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sector_nodes.h>

namespace ringmotor
{
  /** The finite elements on solids and shells of a sector, one numbering over both. */
  struct TiedMeshes
  {
    const dealii::DoFHandler<3> &solid;
    const dealii::Mapping<3> &mapping;
    const dealii::DoFHandler<2, 3> &shell;
    const dealii::Mapping<2, 3> &shell_mapping;
    const SectorNodes &nodes;
  };

  /**
   * Ties the solids to the edge of the shell: the nodes of faces marked ids::shell_root move as the
   * cross-section of the shell, u + theta x d, d being the way from the shell's edge. The meshes
   * need not match, but the shell must not be the finer one: what its edge does between the solid's
   * nodes would be free.
   * @throws dealii::StandardExceptions::ExcMessage if it is, or if a node is not on the normal
   *         of the shell's edge.
   */
  std::vector<SlaveNode> edge_ties(const TiedMeshes &meshes);

  /**
   * Bonds the shell to the faces of the solids marked ids::skin: displacements of its nodes follow
   * the solid there. Its rotations stay free. The meshes need not match.
   * @throws dealii::StandardExceptions::ExcMessage if only a part of a shell's cell lies on such
   * faces.
   */
  std::vector<SlaveNode> skin_ties(const TiedMeshes &meshes);
} // namespace ringmotor
