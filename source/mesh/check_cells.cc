// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_sector.h>
#include <ringmotor/mesh/places.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

#include <vector>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    void check_size(const Triangulation<3> &triangulation, const MeshFile &file)
    {
      const auto [inner_radius, outer_radius] = range_of_radii(triangulation);
      // Ring motors have radii from about a tenth of a millimetre to some decimetres.
      if (outer_radius > 1. + places::file_rounding)
        file.refuse("its largest radius is " + in_metres(outer_radius),
                    "lengths are in m, and motors larger than 1 m are not expected: if the mesh is "
                    "in mm, scale it (Gmsh: Mesh.ScalingFactor = 0.001)");
      if (outer_radius < 5e-5)
        file.refuse("its largest radius is " + in_micrometres(outer_radius),
                    "lengths are in m, and motors smaller than 50 um are not expected: check the "
                    "scale (Gmsh: Mesh.ScalingFactor)");
      if (inner_radius < 1e-3 * outer_radius)
        file.refuse("it reaches the axis of rotation, which is the z axis (smallest radius " +
                        in_millimetres(inner_radius) + ", largest " + in_millimetres(outer_radius) +
                        ")",
                    "move the mesh so that z is the axis of the ring, or leave a hole");
    }

    void check_shapes(const Triangulation<3> &triangulation, const MeshFile &file)
    {
      // 1 at right angles, 0 where edges are parallel, negative where the cell is turned inside out
      const double least_sine   = 1e-3;
      const double outer_radius = range_of_radii(triangulation).second;
      const MappingQ<3> mapping(2);
      const FE_Nothing<3> nothing;
      // The corners matter too: there it is worst.
      FEValues<3> inside(mapping, nothing, QGauss<3>(3), update_jacobians),
          corners(mapping, nothing, QTrapezoid<3>(), update_jacobians);
      for (const auto &cell : triangulation.active_cell_iterators())
      {
        const double shortest  = cell->minimum_vertex_distance() / outer_radius;
        const auto expect_true = [&](const bool condition)
        {
          if (!condition)
            file.refuse_place(shortest,
                              "the cell at " + in_words(cylindrical(cell->center())) +
                                  " is inverted or has no volume",
                              "repair the mesh");
        };
        expect_true(shortest > places::file_rounding); // between coincident nodes nothing is curved
        for (FEValues<3> *const values : {&inside, &corners})
        {
          values->reinit(cell);
          for (const auto &jacobian : values->get_jacobians())
          {
            const auto edges    = jacobian.transpose();
            const double volume = edges[0].norm() * edges[1].norm() * edges[2].norm();
            expect_true(jacobian.determinant() > least_sine * volume);
          }
        }
      }
    }

  } // namespace

  void check_cells(const Triangulation<3> &triangulation, const MeshFile &file)
  {
    check_size(triangulation, file);
    check_shapes(triangulation, file);
  }

  void check_connections(const Triangulation<3> &triangulation, const MeshFile &file)
  {
    auto [vertices, cells, faces] = GridTools::get_coarse_mesh_description(triangulation);
    std::vector<unsigned int> all;
    GridTools::delete_duplicated_vertices(
        vertices, cells, faces, all, places::file_rounding * range_of_radii(triangulation).second);
    if (vertices.size() < triangulation.n_used_vertices())
      file.refuse("parts touch without sharing their nodes (" +
                      std::to_string(triangulation.n_used_vertices() - vertices.size()) +
                      " nodes lie on others)",
                  "glue the volumes before meshing (Gmsh: Coherence, or BooleanFragments)");

    std::vector<bool> reached(triangulation.n_active_cells(), false);
    std::vector<Triangulation<3>::active_cell_iterator> waiting{triangulation.begin_active()};
    unsigned int n_reached = 0;
    while (!waiting.empty())
    {
      const auto cell = waiting.back();
      waiting.pop_back();
      if (reached[cell->active_cell_index()])
        continue;
      reached[cell->active_cell_index()] = true;
      ++n_reached;
      for (const unsigned int face : cell->face_indices())
        if (!cell->at_boundary(face))
          waiting.push_back(cell->neighbor(face));
    }
    if (n_reached < triangulation.n_active_cells())
      file.refuse("the body is in pieces: only " + std::to_string(n_reached) + " of its " +
                      std::to_string(triangulation.n_active_cells()) + " cells are connected",
                  "let neighbouring volumes share a surface (Gmsh: Coherence, or "
                  "BooleanFragments), and give each a physical id");
  }
} // namespace ringmotor
