// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/pictures/lattice.h>
#include <ringmotor/pictures/surface_trace.h>
#include <ringmotor/structure/mirror.h>
#include <ringmotor/structure/shell_trace.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/fe_values_extractors.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Cell    = DoFHandler<3>::active_cell_iterator;
    using Complex = std::complex<double>;

    bool belongs_to(const Cell &cell, const unsigned int face, const Surface surface,
                    const double lowest)
    {
      switch (surface)
      {
      case Surface::tooth_top:
        return cell->at_boundary(face) && cell->face(face)->boundary_id() == ids::tooth_top;
      case Surface::tooth_foot:
        return cell->material_id() == ids::tooth && !cell->at_boundary(face) &&
               cell->neighbor(face)->material_id() == ids::base;
      case Surface::bottom:
        return cell->at_boundary(face) &&
               (cell->face(face)->boundary_id() == ids::bottom ||
                (cell->face(face)->boundary_id() == ids::free && // of a mesh that was read
                 is_same_place(cell->face(face)->center()[2], lowest, cell->diameter())));
      }
      return false;
    }

    /** Adds a point that moves by @p u, Cartesian. */
    void add_point(const Point<3> &x, const std::array<Complex, 3> &u, SurfaceTrace &trace)
    {
      const double r = std::hypot(x[0], x[1]);
      trace.points.push_back(x);
      trace.displacement.push_back(
          {{(x[0] * u[0] + x[1] * u[1]) / r, (x[0] * u[1] - x[1] * u[0]) / r, u[2]}});
    }

    void add_solids(const CyclicSector &sector, const Mode &mode, const Surface surface,
                    SurfaceTrace &trace)
    {
      FEFaceValues<3> values(sector.geometry(), sector.dofs().get_fe(), lattice<2>(trace.order),
                             update_values | update_quadrature_points);
      const FEValuesExtractors::Vector displacement(0);
      std::vector<Tensor<1, 3>> real(values.n_quadrature_points),
          imaginary(values.n_quadrature_points);

      double lowest = std::numeric_limits<double>::max();
      for (const Point<3> &vertex : sector.sector_mesh().triangulation->get_vertices())
        lowest = std::min(lowest, vertex[2]);
      for (const auto &cell : sector.dofs().active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
          if (belongs_to(cell, face, surface, lowest))
          {
            values.reinit(cell, face);
            values[displacement].get_function_values(mode.motion.solid.real, real);
            values[displacement].get_function_values(mode.motion.solid.imaginary, imaginary);
            for (unsigned int q = 0; q < real.size(); ++q)
              add_point(values.quadrature_point(q),
                        {{{real[q][0], imaginary[q][0]},
                          {real[q][1], imaginary[q][1]},
                          {real[q][2], imaginary[q][2]}}},
                        trace);
            ++trace.n_faces;
          }
    }

    /** The lower faces of shells. */
    void add_lower_faces(const CyclicSector &sector, const Mode &mode, SurfaceTrace &trace)
    {
      ShellTrace shell(sector, lattice<2>(trace.order));
      for (const auto &cell : sector.shell_dofs().active_cell_iterators())
      {
        shell.reinit(cell, mode.motion.shell);
        const double height = sector.sector_mesh().sections.at(cell->material_id()).lower_face();
        for (unsigned int q = 0; q < shell.size(); ++q)
          add_point(shell.position(q, height), shell.displacement(q, height), trace);
        ++trace.n_faces;
      }
    }

    void add_mirror_image(SurfaceTrace &trace)
    {
      const std::size_t n_points = trace.points.size();
      for (std::size_t i = 0; i < n_points; ++i)
      {
        const Point<3> x               = trace.points[i];
        const std::array<Complex, 3> u = trace.displacement[i];
        trace.points.push_back(mirrored(x));
        trace.displacement.push_back(mirrored(u));
      }
      trace.n_faces *= 2;
    }
  } // namespace

  SurfaceTrace surface_trace(const CyclicSector &sector, const Mode &mode, const Surface surface)
  {
    SurfaceTrace trace;
    trace.order = sector.dofs().get_fe().degree;
    add_solids(sector, mode, surface, trace);
    if (surface == Surface::bottom && sector.shell_dofs().has_active_dofs())
      add_lower_faces(sector, mode, trace);
    if (sector.sector_mesh().form == SectorForm::half)
      add_mirror_image(trace);
    return trace;
  }
} // namespace ringmotor
