// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/interface_grading.h>
#include <ringmotor/mesh/revolved_body.h>
#include <ringmotor/mesh/sector_mesh.h>

namespace ringmotor
{
  /** How finely ring and flange of the rotor are meshed. */
  struct RotorGrading
  {
    double first   = 0.5; ///< width of the cells at re-entrant corners, over what is thinnest there
    double ratio   = 0.3; ///< of the distances of successive mesh lines from these edges
    double longest = 0.6; ///< cell, over the width or height of the ring beyond these edges:
                          ///< longer ones are too stiff in bending
    unsigned int n_span = 2; ///< cells of a flange that is a shell, between lip and ring
    unsigned int n_lip  = 1; ///< cells across its lip, at least

    /** The gradings 0, 1, 2, ... of a sequence for elements of second degree. */
    static RotorGrading level(const unsigned int level);

    bool operator==(const RotorGrading &other) const
    {
      return first == other.first && ratio == other.ratio && longest == other.longest &&
             n_span == other.n_span && n_lip == other.n_lip;
    }
  };

  /**
   * Meshes the sector of a rotor that belongs to one tooth, with cells of exact cylindrical shape.
   * Cells shrink towards re-entrant corners. @p lip sets the division of the contact line, with
   * cells that shrink towards the outer end and away from the face.
   */
  SectorMesh make_rotor_sector(const RevolvedBody &rotor, const SectorForm form,
                               const RotorGrading &grading, MPI_Comm communicator,
                               const InterfaceGrading &lip = {});
} // namespace ringmotor
