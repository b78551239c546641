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
   * Ties the edge of the shell to the solids: its displacement and rotation there are those of the
   * faces marked ids::shell_root, averaged across the shell's thickness with weights such that the
   * forces on the solid are those of beam theory: linear normal stresses and parabolic shear
   * stresses. (A cross-section that stays rigid would make the root too stiff.) The rotation about
   * the shell's normal stays free. The meshes need not match, but the solid must not be the finer
   * one: the shell would constrain it only at single points.
   * @throws dealii::StandardExceptions::ExcMessage if it is, or if the faces do not cover the
   *         shell's thickness.
   */
  std::vector<SlaveNode> edge_ties(const TiedMeshes &meshes, const SectorMesh &mesh);

  /**
   * Bonds the shell to the faces of the solids marked ids::skin: displacements of its nodes follow
   * the solid there. Its rotations stay free. The meshes need not match.
   * @throws dealii::StandardExceptions::ExcMessage if only a part of a shell's cell lies on such
   * faces.
   */
  std::vector<SlaveNode> skin_ties(const TiedMeshes &meshes);
} // namespace ringmotor
