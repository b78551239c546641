// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/distributed/shared_tria.h>

#include <memory>

namespace ringmotor
{
  /** Which part of the cyclic body is meshed. */
  enum class SectorForm
  {
    half, ///< theta in [0, alpha/2]; the plane theta = 0 is a mirror plane of the body
    whole ///< a sector of angle alpha between two cuts that match by a turn of alpha
  };

  /**
   * The mesh of one sector (or half of one) of a body with n_sectors-fold symmetry about the z
   * axis. Faces carry the boundary ids and cells the material ids of mesh/ids.h. Every rank knows
   * all cells; METIS tells which of them it owns.
   */
  struct SectorMesh
  {
    std::unique_ptr<dealii::parallel::shared::Triangulation<3>> triangulation;
    SectorForm form        = SectorForm::half;
    unsigned int n_sectors = 1;
  };

  /** An empty triangulation that METIS partitions over the ranks of @p communicator. */
  std::unique_ptr<dealii::parallel::shared::Triangulation<3>>
  empty_triangulation(MPI_Comm communicator);
} // namespace ringmotor
