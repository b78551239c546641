// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/parameters/errors.h>

#include <string>

namespace ringmotor
{
  /** A mistake in a mesh file: the file, what was @p found in it, and @p what_to_do. */
  UserError mesh_file_error(const std::string &file, const std::string &found,
                            const std::string &what_to_do);

  /**
   * Looks for mistakes in the shape of a sector that was read from @p file: lengths that are not in
   * m, a body that touches the axis or is in pieces, cuts that do not match under a rotation by
   * 2 pi/n_sectors or are not fully marked, cells beyond the cuts, and cells that are inverted.
   *
   * @throws UserError naming `Stator/Mesh file` and the place in the mesh.
   */
  void check_sector(const SectorMesh &mesh, const std::string &file);
} // namespace ringmotor
