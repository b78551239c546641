// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/contact_line.h>
#include <ringmotor/mesh/interface_grading.h>
#include <ringmotor/mesh/sector_mesh.h>

namespace ringmotor
{
  // Finer meshes of a body that was read: whole sheets of its cells are cut, see SheetCuts, so that
  // cells shrink towards edges, and no hanging nodes appear.

  /** A copy of a sector, whose coarsest cells are the active ones, on other ranks.
   * @pre @p mesh has no shell and no hanging nodes */
  SectorMesh copy_of(const SectorMesh &mesh, MPI_Comm communicator);

  /** The tooth of a stator's sector, with ids::tooth_foot where it stands on the base.
   * @pre as copy_of() */
  SectorMesh tooth_of(const SectorMesh &stator, MPI_Comm communicator);

  /** The cells along theta in which a face in contact is divided. */
  enum class AroundContact
  {
    towards_side, ///< they shrink towards the side of the tooth
    evenly        ///< as a rotor's
  };

  /**
   * Cuts the cells at the faces with the id @p contact into as many as a @p grading says, with its
   * ratio: across them, those at the outer end, and those on the faces away from them; along theta,
   * those at the side of the tooth, or all evenly (into a power of two); and those on the foot.
   */
  void cut_at_contact(SectorMesh &mesh, const dealii::types::boundary_id contact,
                      const InterfaceGrading &grading, const AroundContact around);

  /** Cuts the cells at the re-entrant edges of a body until those there have a @p width over what
   * they had, with a @p ratio of successive distances. */
  void cut_at_reentrant_edges(SectorMesh &mesh, const double width, const double ratio);

  /** Faces with the id @p contact whose middle lies at other radii get the id ids::free. */
  void limit_contact(SectorMesh &mesh, const dealii::types::boundary_id contact,
                     const RadialRange &radii);
} // namespace ringmotor
