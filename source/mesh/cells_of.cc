// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/cells_of.h>
#include <ringmotor/mesh/places.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  CellsOf::CellsOf(const SectorMesh &mesh) : of(mesh)
  {
    Assert(!mesh.shell, ExcNotImplemented());
  }

  unsigned int CellsOf::vertex(const Cell &cell, const Point<3> &unit)
  {
    std::vector<unsigned int> around; // corners with an influence
    Point<3> place;
    for (unsigned int corner = 0; corner < 8; ++corner)
      if (const double weight = GeometryInfo<3>::d_linear_shape_function(unit, corner);
          weight != 0.)
      {
        around.push_back(cell->vertex_index(corner));
        place += weight * cylindrical(cell->vertex(corner));
      }
    const Point<3> x =
        around.size() == 1 ? of.triangulation->get_vertices()[around.front()] : cartesian(place);
    std::sort(around.begin(), around.end());
    const auto [entry, is_new] = number.emplace(around, vertices.size());
    if (is_new)
      vertices.push_back(x);
    return entry->second;
  }

  void CellsOf::add(const Cell &cell, const Lines &lines)
  {
    const auto n_parts = [&](const unsigned int direction) { return lines[direction].size() - 1; };
    std::array<std::size_t, 3> part;
    for (part[2] = 0; part[2] < n_parts(2); ++part[2])
      for (part[1] = 0; part[1] < n_parts(1); ++part[1])
        for (part[0] = 0; part[0] < n_parts(0); ++part[0])
        {
          CellData<3> data;
          data.material_id = cell->material_id();
          for (unsigned int corner = 0; corner < 8; ++corner)
          {
            Point<3> unit;
            for (unsigned int d = 0; d < 3; ++d)
              unit[d] = lines[d][part[d] + (corner >> d & 1)];
            data.vertices[corner] = vertex(cell, unit);
          }
          for (const unsigned int face : GeometryInfo<3>::face_indices())
          {
            const std::size_t outermost = face % 2 == 0 ? 0 : n_parts(face / 2) - 1;
            if (!cell->at_boundary(face) || part[face / 2] != outermost)
              continue;
            Quad quad;
            for (unsigned int i = 0; i < 4; ++i)
              quad[i] = data.vertices[GeometryInfo<3>::face_to_cell_vertices(face, i)];
            std::sort(quad.begin(), quad.end());
            faces[quad] = cell->face(face)->boundary_id();
          }
          cells.push_back(data);
        }
  }

  SectorMesh CellsOf::mesh(const MPI_Comm communicator, const types::boundary_id inner) const
  {
    SectorMesh mesh{empty_triangulation<3>(communicator), of.form, of.n_sectors};
    mesh.has_cuts                 = of.has_cuts;
    mesh.foundations              = of.foundations;
    std::vector<CellData<3>> data = cells;
    GridTools::consistently_order_cells(data);
    mesh.triangulation->create_triangulation(vertices, data, SubCellData());
    for (const auto &face : mesh.triangulation->active_face_iterators())
      if (face->at_boundary())
      {
        Quad quad;
        for (unsigned int i = 0; i < 4; ++i)
          quad[i] = face->vertex_index(i);
        std::sort(quad.begin(), quad.end());
        const auto known = faces.find(quad);
        face->set_boundary_id(known == faces.end() ? inner : known->second);
      }
    mesh.triangulation->set_all_manifold_ids(0);
    mesh.triangulation->set_manifold(0, of.triangulation->get_manifold(0));
    return mesh;
  }
} // namespace ringmotor
