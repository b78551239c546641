// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sections.h>

#include <deal.II/distributed/shared_tria.h>

#include <map>
#include <memory>

namespace ringmotor
{
  /** Which part of the cyclic body is meshed. */
  enum class SectorForm
  {
    half,  ///< theta in [0, alpha/2]; the plane theta = 0 is a mirror plane of the body
    whole, ///< a sector of angle alpha between two cuts that match under a rotation by alpha
    ring   ///< all of it, without cuts and whatever its symmetry
  };

  /**
   * The mesh of one sector (or half of one) of a body with n_sectors-fold symmetry about the z
   * axis, or of a whole ring, with n_sectors = 1: solid cells, and where there are thin parts also
   * the reference surface of a shell. Faces (of a shell: edges) carry the boundary ids and cells
   * the material ids of mesh/ids.h. Every rank stores all cells; METIS determines which of them it
   * owns.
   */
  struct SectorMesh
  {
    std::unique_ptr<dealii::parallel::shared::Triangulation<3>> triangulation; ///< of the solids
    SectorForm form        = SectorForm::half;
    unsigned int n_sectors = 1;
    bool has_cuts          = true; ///< false: a part of the sector that does not reach its cuts

    std::unique_ptr<dealii::parallel::shared::Triangulation<2, 3>> shell{}; ///< null: no shell
    std::map<dealii::types::material_id, ShellSection> sections{}; ///< of the cells of the shell
    std::map<dealii::types::boundary_id, BarSection> bars{};       ///< by the id of edges of solids
    std::map<dealii::types::boundary_id, double>
        foundations{}; ///< normal stiffness per area (N/m^3) by the id of faces of solids

    /** Of solids and shell. */
    std::size_t n_cells() const
    {
      return triangulation->n_active_cells() + (shell ? shell->n_active_cells() : 0);
    }
  };

  /** An empty triangulation that METIS partitions over the ranks of @p communicator. */
  template <int dim>
  std::unique_ptr<dealii::parallel::shared::Triangulation<dim, 3>>
  empty_triangulation(MPI_Comm communicator);

  /**
   * Adds a shell of quadrilaterals to the sector, described as for
   * Triangulation::create_triangulation. They are oriented such that all normals point up (towards
   * +z). Edges on the planes of a sector that is symmetric about theta = 0 get their boundary ids.
   */
  void add_shell(SectorMesh &mesh, const std::vector<dealii::Point<3>> &vertices,
                 std::vector<dealii::CellData<2>> cells);
} // namespace ringmotor
