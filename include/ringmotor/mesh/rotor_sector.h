// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/interface_grading.h>
#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/parameters/motor.h>

namespace ringmotor
{
  /**
   * Meshes the sector of the rotor that belongs to one tooth: ring, flange and lip in solid cells
   * or, from half its thickness off the ring on, the flange with its lip as a shell; with the
   * cylindrical coordinates as its shape. z is the height above the plane of the tooth tops. Cells
   * shrink towards the two edges where the flange meets the ring, from level to level to 0.3 of
   * their size. @p lip divides the lip, with cells that get smaller towards its outer line and its
   * lower face. The geometry must have passed check_for_stator().
   */
  SectorMesh make_rotor_sector(const RotorGeometry &rotor, const unsigned int n_teeth,
                               const SectorForm form, const unsigned int level,
                               MPI_Comm communicator, const InterfaceGrading &lip = {});
} // namespace ringmotor
