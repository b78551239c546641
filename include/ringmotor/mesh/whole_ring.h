// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>

namespace ringmotor
{
  /**
   * The mesh of the whole ring of which @p part is one sector or half of one: as many copies of it
   * as the body has sectors, turned about the z axis and, of a half sector, mirrored. Its cells are
   * divided over the ranks of @p communicator. A mesh that is a whole ring already is copied.
   *
   * @pre no hanging nodes
   */
  SectorMesh whole_ring(const SectorMesh &part, MPI_Comm communicator);
} // namespace ringmotor
