// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>

#include <array>
#include <map>
#include <vector>

namespace ringmotor
{
  /**
   * Makes a mesh of some cells of another one, whole or divided along their reference directions.
   * All are coarse cells of the new mesh. (deal.II's anisotropic refinement may refine cells in
   * more directions than asked for, and it gives lines inside of faces that were cut twice two
   * numbers.) New vertices lie where cylindrical coordinates are interpolated linearly between
   * those of a cell.
   */
  class CellsOf
  {
  public:
    using Cell = dealii::Triangulation<3>::active_cell_iterator;
    /** Where a cell is divided in each direction: 0, ..., 1 in ascending order. */
    using Lines = std::array<std::vector<double>, 3>;

    /** @pre solids without hanging nodes, no shell. @p mesh must outlive this object */
    explicit CellsOf(const SectorMesh &mesh);

    /** Edges that cells have in common are divided alike, at one place at most. */
    void add(const Cell &cell, const Lines &lines);
    void add(const Cell &cell) { add(cell, {{{0., 1.}, {0., 1.}, {0., 1.}}}); }

    /** @param inner id of outer faces that were not outer ones of the other mesh */
    SectorMesh mesh(MPI_Comm communicator, const dealii::types::boundary_id inner) const;

  private:
    using Quad = std::array<unsigned int, 4>; ///< vertices in ascending order

    unsigned int vertex(const Cell &cell, const dealii::Point<3> &unit);

    const SectorMesh &of;
    std::map<std::vector<unsigned int>, unsigned int> number; ///< by the vertices around it
    std::vector<dealii::Point<3>> vertices;
    std::vector<dealii::CellData<3>> cells;
    std::map<Quad, dealii::types::boundary_id> faces;
  };
} // namespace ringmotor
