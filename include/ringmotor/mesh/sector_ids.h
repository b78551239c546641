// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/body_origin.h>
#include <ringmotor/mesh/gmsh_mesh.h>

namespace ringmotor
{
  bool is_volume(const GmshMesh::Element &element);
  bool is_marked_surface(const GmshMesh::Element &element);

  /** ", near r = ..." of the middle of some nodes. */
  std::string near_nodes(const GmshMesh &mesh, const std::vector<unsigned int> &nodes);

  /** The volumes that a sector of this body can have, for messages. */
  std::string volumes_of(const BodyOf body);

  /**
   * Gives the volumes and surfaces of a sector's mesh the ids of mesh/ids.h: by their physical
   * names, or, of a stator, by their numbers.
   * @throws UserError for volumes without a name or number, and for others than those of the body
   */
  void take_ids(GmshMesh &mesh, const BodyOf body);
} // namespace ringmotor
