// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/body_origin.h>
#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/parameters/modes.h>

#include <string>

namespace ringmotor
{
  /**
   * Reads a sector of hexahedra from a Gmsh file (see read_gmsh(), lengths in m) with the physical
   * names, or, of a stator, the physical ids of mesh/ids.h, see meshes/README.md. Faces 11 and 12
   * make it a half sector, 13 and 14 a whole one. Without any of them it is a whole ring, if
   * @p domain is one, which need not have equal sectors. Cells are curved around the z axis:
   * cylindrical coordinates are interpolated linearly between the vertices of the file, also where
   * the mesh is refined later. A plane that contains neither r nor z, such as the wall of a slot,
   * becomes slightly curved between these vertices. Vertices are where they are meant to be, see
   * move_to_exact_places().
   *
   * @throws UserError naming `Stator/Mesh file` or `Rotor/Mesh file` for a file that cannot be
   * read, elements that are not hexahedra of first order, unknown names, unknown or several ids,
   * marked surfaces that are not outer ones and cuts that are missing, and for all that
   * check_cells(), check_connections(), check_cuts(), check_tooth() and check_lip() find.
   */
  SectorMesh read_sector(const std::string &file, const unsigned int n_sectors,
                         MPI_Comm communicator, const BodyOf of = BodyOf::stator,
                         const Domain domain = Domain::sector);
} // namespace ringmotor
