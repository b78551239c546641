// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>

#include <string>

namespace ringmotor
{
  /**
   * Reads a sector of hexahedra from a Gmsh file (format 2.2 or 4.1, lengths in m) with the
   * physical ids of mesh/ids.h. Faces 11 and 12 make it a half sector, 13 and 14 a whole one. Edges
   * are curved around the z axis (cylindrical coordinates are interpolated linearly).
   * @throws UserError naming `Stator/Mesh file` for a file that cannot be read, cells that are not
   *         hexahedra, inverted cells, unknown ids, and cuts that are missing.
   */
  SectorMesh read_sector(const std::string &file, const unsigned int n_sectors,
                         MPI_Comm communicator);
} // namespace ringmotor
