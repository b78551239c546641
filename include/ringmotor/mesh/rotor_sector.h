// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/interface_grading.h>
#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/parameters/motor.h>

namespace ringmotor
{
  /** How finely ring and flange of the rotor are meshed. */
  struct RotorGrading
  {
    double first   = 0.5;    ///< width of the cells where flange and ring meet, over its thickness
    double ratio   = 0.3;    ///< of the distances of successive mesh lines from these edges
    double longest = 0.6;    ///< cell, over the width or height of the ring beyond these edges:
                             ///< longer ones are too stiff in bending
    unsigned int n_span = 2; ///< cells of a flange that is a shell, between lip and ring
    unsigned int n_lip  = 1; ///< cells across its lip, at least

    /** The gradings 0, 1, 2, ... of a sequence for elements of second degree. */
    static RotorGrading level(const unsigned int level);
  };

  /**
   * Meshes the sector of the rotor that belongs to one tooth, with cells of exact cylindrical
   * shape: ring, flange and lip as solids, or the flange with its lip as a shell that starts half
   * its thickness away from the ring. z is the height above the plane of the tooth tops. Cells
   * shrink towards the two edges where the flange meets the ring. @p lip sets the division of the
   * lip, with cells that shrink towards its outer edge and its lower face. The geometry must have
   * passed check_for_stator().
   */
  SectorMesh make_rotor_sector(const RotorGeometry &rotor, const unsigned int n_teeth,
                               const SectorForm form, const RotorGrading &grading,
                               MPI_Comm communicator, const InterfaceGrading &lip = {});
} // namespace ringmotor
