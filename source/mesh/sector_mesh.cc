// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/sector_mesh.h>

#include <deal.II/grid/grid_tools.h>

#include <utility>

namespace ringmotor
{
  using namespace dealii;

  template <int dim>
  std::unique_ptr<parallel::shared::Triangulation<dim, 3>>
  empty_triangulation(MPI_Comm communicator)
  {
    using Mesh = parallel::shared::Triangulation<dim, 3>;
    return std::make_unique<Mesh>(communicator, Triangulation<dim, 3>::MeshSmoothing::none,
                                  /*allow_artificial_cells =*/false,
                                  Mesh::Settings::partition_metis);
  }

  template std::unique_ptr<parallel::shared::Triangulation<3, 3>> empty_triangulation(MPI_Comm);
  template std::unique_ptr<parallel::shared::Triangulation<2, 3>> empty_triangulation(MPI_Comm);

  namespace
  {
    /** Gives the edges of the shell on the sector's planes their ids. */
    void mark_planes(SectorMesh &mesh)
    {
      const double half_pitch = numbers::PI / mesh.n_sectors;
      const bool half         = mesh.form == SectorForm::half;
      for (const auto &cell : mesh.shell->active_cell_iterators())
        for (const auto &edge : cell->face_iterators())
          if (edge->at_boundary())
          {
            const auto lies_at = [&](const double angle)
            {
              for (const unsigned int i : edge->vertex_indices())
                if (!is_same_place(cylindrical(edge->vertex(i))[1], angle, 1.))
                  return false;
              return true;
            };
            if (lies_at(half_pitch))
              edge->set_boundary_id(half ? ids::cut : ids::cut_high);
            else if (lies_at(half ? 0. : -half_pitch))
              edge->set_boundary_id(half ? ids::mirror : ids::cut_low);
          }
    }
  } // namespace

  void add_shell(SectorMesh &mesh, const std::vector<Point<3>> &vertices,
                 std::vector<CellData<2>> cells)
  {
    for (CellData<2> &cell : cells)
    {
      const Tensor<1, 3> x = vertices[cell.vertices[3]] - vertices[cell.vertices[0]];
      const Tensor<1, 3> y = vertices[cell.vertices[2]] - vertices[cell.vertices[1]];
      if (cross_product_3d(x, y)[2] < 0.)
        std::swap(cell.vertices[1], cell.vertices[2]);
    }
    GridTools::consistently_order_cells(cells); // rotates them about their normals only
    mesh.shell = empty_triangulation<2>(mesh.triangulation->get_communicator());
    mesh.shell->create_triangulation(vertices, cells, SubCellData());
    mark_planes(mesh);
  }
} // namespace ringmotor
