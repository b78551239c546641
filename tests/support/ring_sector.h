// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/sector_mesh.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>
#include <vector>

namespace ringmotor::tests
{
  /**
   * Sweeps a plane mesh of the cross-section, (r, z) in m, around the z axis: a (half) sector of a
   * ring of @p n_sectors equal ones with @p n_around cells in theta.
   */
  inline SectorMesh sweep(const dealii::Triangulation<2> &section, const unsigned int n_sectors,
                          const SectorForm form, const unsigned int n_around,
                          MPI_Comm communicator = MPI_COMM_WORLD)
  {
    using namespace dealii;
    const double half_pitch = numbers::PI / n_sectors;
    const double length     = form == SectorForm::half ? half_pitch : 2. * half_pitch;

    SectorMesh mesh{empty_triangulation<3>(communicator), form, n_sectors};
    Triangulation<3> &triangulation = *mesh.triangulation;
    GridGenerator::extrude_triangulation(section, n_around + 1, length, triangulation);
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      cell->set_material_id(ids::base);
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
        {
          const double along = face->center()[2];
          if (along < 1e-9 * length)
            face->set_boundary_id(form == SectorForm::half ? ids::cut : ids::cut_high);
          else if (along > (1. - 1e-9) * length)
            face->set_boundary_id(form == SectorForm::half ? ids::mirror : ids::cut_low);
          else
            face->set_boundary_id(ids::free);
        }
    }
    // (r, z, -theta) is right-handed: the extruded coordinate runs opposite to theta.
    GridTools::transform(
        [&](const Point<3> &x)
        {
          const double theta = half_pitch - x[2];
          return Point<3>(x[0] * std::cos(theta), x[0] * std::sin(theta), x[1]);
        },
        triangulation);
    triangulation.set_all_manifold_ids(0);
    triangulation.set_manifold(0, CylindricalManifold<3>(2));
    return mesh;
  }

  /** Cells of these widths in r from @p inner_radius on, and @p n_axial equal ones in z. */
  inline SectorMesh rectangular_ring(const double inner_radius, const std::vector<double> &widths,
                                     const double height, const unsigned int n_axial,
                                     const unsigned int n_sectors, const SectorForm form,
                                     const unsigned int n_around,
                                     MPI_Comm communicator = MPI_COMM_WORLD)
  {
    using namespace dealii;
    double outer_radius = inner_radius;
    for (const double width : widths)
      outer_radius += width;
    Triangulation<2> section;
    GridGenerator::subdivided_hyper_rectangle(
        section, {widths, std::vector<double>(n_axial, height / n_axial)},
        Point<2>(inner_radius, 0.), Point<2>(outer_radius, height));
    return sweep(section, n_sectors, form, n_around, communicator);
  }

  /** A flat ring consisting of a shell only, @p n_radial by @p n_around cells. */
  inline SectorMesh shell_ring(const double inner_radius, const double outer_radius,
                               const ShellSection &section, const unsigned int n_radial,
                               const unsigned int n_sectors, const SectorForm form,
                               const unsigned int n_around)
  {
    using namespace dealii;
    SectorMesh mesh;
    mesh.triangulation       = empty_triangulation<3>(MPI_COMM_WORLD);
    mesh.form                = form;
    mesh.n_sectors           = n_sectors;
    mesh.sections[ids::base] = section;
    const double last_angle  = numbers::PI / n_sectors;
    const double first_angle = form == SectorForm::half ? 0. : -last_angle;
    std::vector<Point<3>> vertices;
    std::vector<CellData<2>> cells;
    for (unsigned int i = 0; i <= n_radial; ++i)
      for (unsigned int j = 0; j <= n_around; ++j)
      {
        const double r     = inner_radius + i * (outer_radius - inner_radius) / n_radial;
        const double theta = first_angle + j * (last_angle - first_angle) / n_around;
        vertices.emplace_back(r * std::cos(theta), r * std::sin(theta), 0.);
        if (i < n_radial && j < n_around)
        {
          const unsigned int corner = i * (n_around + 1) + j;
          CellData<2> cell;
          cell.vertices    = {corner, corner + n_around + 1, corner + 1, corner + n_around + 2};
          cell.material_id = ids::base;
          cells.push_back(cell);
        }
      }
    add_shell(mesh, vertices, cells);
    mesh.shell->set_all_manifold_ids(0);
    mesh.shell->set_manifold(0, CylindricalManifold<2, 3>(2));
    return mesh;
  }

  /** Radius, angle and turns along the surface of a torus about the z axis. */
  class TorusChart : public dealii::ChartManifold<3, 3>
  {
  public:
    explicit TorusChart(const double centre_radius)
        : dealii::ChartManifold<3, 3>(
              dealii::Tensor<1, 3>({0., 2. * dealii::numbers::PI, 2. * dealii::numbers::PI})),
          centre_radius(centre_radius)
    {
    }

    dealii::Point<3> pull_back(const dealii::Point<3> &x) const override
    {
      const double outward = std::hypot(x[0], x[1]) - centre_radius;
      return {std::hypot(outward, x[2]), turn(std::atan2(x[2], outward)),
              turn(std::atan2(x[1], x[0]))};
    }

    dealii::Point<3> push_forward(const dealii::Point<3> &chart) const override
    {
      const double r = centre_radius + chart[0] * std::cos(chart[1]);
      return {r * std::cos(chart[2]), r * std::sin(chart[2]), chart[0] * std::sin(chart[1])};
    }

    std::unique_ptr<dealii::Manifold<3, 3>> clone() const override
    {
      return std::make_unique<TorusChart>(centre_radius);
    }

  private:
    /** Into [0, 2 pi), as the periodic chart requires. */
    static double turn(const double angle)
    {
      return angle < 0. ? angle + 2. * dealii::numbers::PI : angle;
    }

    double centre_radius;
  };

  /** A ring of solid round cross-section, a torus. */
  inline SectorMesh round_ring(const double centre_radius, const double diameter,
                               const unsigned int n_sectors, const SectorForm form,
                               const unsigned int n_around, MPI_Comm communicator = MPI_COMM_WORLD)
  {
    using namespace dealii;
    // Arcs of 22.5 degrees: quadratic arcs of 45 degrees would reduce the section's I/A by 8e-4.
    Triangulation<2> disc, section;
    GridGenerator::hyper_ball_balanced(disc, Point<2>(centre_radius, 0.), 0.5 * diameter);
    disc.refine_global(1);
    GridGenerator::flatten_triangulation(disc, section);
    SectorMesh mesh = sweep(section, n_sectors, form, n_around, communicator);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == ids::free)
          face->set_all_manifold_ids(1);
    mesh.triangulation->set_manifold(1, TorusChart(centre_radius));
    return mesh;
  }
} // namespace ringmotor::tests
