// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/interface_grading.h>
#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/parameters/motor.h>

namespace ringmotor
{
  /**
   * Meshes the sector of the rotor that belongs to one tooth, with cells of exact cylindrical
   * shape: ring, flange and lip as solids, or the flange with its lip as a shell that starts half
   * its thickness away from the ring. z is the height above the plane of the tooth tops. Cells
   * shrink towards the two edges where the flange meets the ring, by a factor of 0.3 from level to
   * level. @p lip sets the division of the lip, with cells that shrink towards its outer edge and
   * its lower face. The geometry must have passed check_for_stator().
   */
  SectorMesh make_rotor_sector(const RotorGeometry &rotor, const unsigned int n_teeth,
                               const SectorForm form, const unsigned int level,
                               MPI_Comm communicator, const InterfaceGrading &lip = {});
} // namespace ringmotor
