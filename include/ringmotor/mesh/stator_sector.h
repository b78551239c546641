// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/parameters/motor.h>

namespace ringmotor
{
  /**
   * How finely the stator's sector is divided. The slot root is a re-entrant edge: what rules the
   * error there is not the number of cells but that they shrink geometrically towards it.
   */
  struct SectorGrading
  {
    unsigned int n_layers =
        0; ///< layers of cells towards the slot root, within half a slot's width
    unsigned int n_radial = 1;   ///< cells from the inner to the outer side
    double ratio          = 0.3; ///< each layer is this much thinner than the next

    /** The gradings 0, 1, 2, ... of a sequence in which the errors of all directions stay balanced.
     */
    static SectorGrading level(const unsigned int level)
    {
      return {level / 2, 1 + (level + 1) / 2, 0.3};
    }
  };

  /**
   * Meshes the sector of the stator: ceramic ring, base ring and tooth, with curved cells of exact
   * shape (SectorManifold). The geometry must have passed check_for_stator().
   */
  SectorMesh make_stator_sector(const StatorGeometry &stator, const unsigned int n_teeth,
                                const SectorForm form, const SectorGrading &grading,
                                MPI_Comm communicator);
} // namespace ringmotor
