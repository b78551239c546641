// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/interface_grading.h>
#include <ringmotor/mesh/revolved_body.h>
#include <ringmotor/mesh/sector_mesh.h>

#include <optional>

namespace ringmotor
{
  /** Numbers of even cells of the stator's half sector. */
  struct EvenCells
  {
    unsigned int n_tooth, n_slot;  ///< along the half tooth and the half slot
    unsigned int n_above, n_below; ///< along the height of the tooth and that of the base
  };

  /**
   * How finely a body's sector is meshed. The slot root is a re-entrant edge, as are corners of
   * the section: the error there depends less on the number of cells than on their geometric
   * grading towards them.
   */
  struct SectorGrading
  {
    unsigned int n_layers = 0;   ///< layers of cells around re-entrant edges
    unsigned int n_radial = 2;   ///< cells from the inner to the outer side of a tooth, at least
    double ratio          = 0.2; ///< inner over outer distance of each layer from the edge
    /** All cells are even, also from the inner to the outer side, if there is a value. */
    std::optional<EvenCells> even = {};

    /** The gradings 0, 1, 2, ... of a sequence in which the errors of all directions stay
     * balanced. */
    static SectorGrading level(const unsigned int level)
    {
      if (level == 0)
        return {0, 2, 0.2};
      return {1 + level / 2, 2 + (level - 1) / 2, 0.2};
    }
  };

  /** Meshes the sector of a body, with curved cells of exact shape. Outer edges of the tooth tops
   * carry ids::target_plate. */
  SectorMesh make_sector(const RevolvedBody &body, const SectorForm form,
                         const SectorGrading &grading, MPI_Comm communicator);

  /** Meshes half of a single tooth, clamped at its foot. */
  SectorMesh make_tooth(const RevolvedBody &stator, const SectorGrading &grading,
                        MPI_Comm communicator);

  /**
   * Meshes half of a single tooth for its contact with a lip that covers the radii @p lip_inner to
   * @p lip_outer (m). The faces of the tooth's top below the lip carry ids::tooth_top, those of its
   * foot ids::tooth_foot. Cells shrink towards the outer edge of the strip where lip and tooth
   * overlap, and towards the sides and the top of the tooth.
   */
  SectorMesh make_contact_tooth(const RevolvedBody &stator, const double lip_inner,
                                const double lip_outer, const InterfaceGrading &grading,
                                MPI_Comm communicator);
} // namespace ringmotor
