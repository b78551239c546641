// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/graded_lines.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/rotor_sector.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Lines from @p from to @p to, the finer ones at @p from; without @p from itself. */
    void append_lines(std::vector<double> &lines, const double from, const double to,
                      const double first)
    {
      const std::vector<double> distances = graded_lines(std::abs(to - from), first);
      for (unsigned int i = 1; i < distances.size(); ++i)
        lines.push_back(from + (to > from ? distances[i] : -distances[i]));
    }

    std::vector<double> sorted(std::vector<double> lines)
    {
      std::sort(lines.begin(), lines.end());
      return lines;
    }

    std::vector<double> widths(const std::vector<double> &lines)
    {
      std::vector<double> widths;
      for (unsigned int i = 1; i < lines.size(); ++i)
        widths.push_back(lines[i] - lines[i - 1]);
      return widths;
    }

    /** Sets the boundary ids while the mesh is still the box of cylindrical coordinates (r, theta,
     * z). */
    void set_boundary_ids(Triangulation<3> &box, const RotorGeometry &rotor, const SectorForm form,
                          const double first_angle, const double last_angle)
    {
      const auto at = [](const double a, const double b) { return std::abs(a - b) < 1e-10; };
      for (const auto &cell : box.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
          {
            const Point<3> center = face->center();
            const bool level =
                at(face->vertex(0)[2], face->vertex(3)[2]) && at(face->vertex(0)[2], center[2]);
            face->set_boundary_id(at(center[1], last_angle)
                                      ? (form == SectorForm::half ? ids::cut : ids::cut_high)
                                  : at(center[1], first_angle)
                                      ? (form == SectorForm::half ? ids::mirror : ids::cut_low)
                                  : level && at(center[2], rotor.ring_upper_face) ? ids::ring_top
                                  : level && at(center[2], rotor.flange_lower_face) &&
                                          center[0] < rotor.lip_outer_radius
                                      ? ids::lip
                                  : at(center[0], rotor.ring_inner_radius) ? ids::ring_bore
                                                                           : ids::free);
          }
    }
  } // namespace

  SectorMesh make_rotor_sector(const RotorGeometry &rotor, const unsigned int n_teeth,
                               const SectorForm form, const unsigned int level,
                               MPI_Comm communicator)
  {
    const double flange_top    = rotor.flange_lower_face + rotor.flange_thickness;
    const double flange_middle = 0.5 * (rotor.flange_lower_face + flange_top);
    const double first         = 0.5 * rotor.flange_thickness * std::pow(0.3, level);

    std::vector<double> r_lines{rotor.lip_inner_radius, rotor.ring_inner_radius};
    append_lines(r_lines, rotor.ring_inner_radius, rotor.lip_outer_radius, first);
    append_lines(r_lines, rotor.ring_inner_radius, rotor.ring_outer_radius, first);
    std::vector<double> z_lines{rotor.flange_lower_face, flange_top};
    append_lines(z_lines, rotor.flange_lower_face, rotor.ring_lower_face, first);
    append_lines(z_lines, rotor.flange_lower_face, flange_middle, first);
    append_lines(z_lines, flange_top, flange_middle, first);
    append_lines(z_lines, flange_top, rotor.ring_upper_face, first);
    r_lines = sorted(r_lines);
    z_lines = sorted(z_lines);
    // The middle of the flange was met from both sides.
    z_lines.erase(std::unique(z_lines.begin(), z_lines.end()), z_lines.end());

    const double half_pitch  = numbers::PI / n_teeth;
    const double first_angle = form == SectorForm::half ? 0. : -half_pitch;
    const std::vector<double> theta_widths(form == SectorForm::half ? 1 : 2, half_pitch);

    Table<3, types::material_id> materials(r_lines.size() - 1, theta_widths.size(),
                                           z_lines.size() - 1);
    for (unsigned int i = 0; i + 1 < r_lines.size(); ++i)
      for (unsigned int j = 0; j < theta_widths.size(); ++j)
        for (unsigned int k = 0; k + 1 < z_lines.size(); ++k)
        {
          const bool in_ring   = r_lines[i] >= rotor.ring_inner_radius;
          const bool in_flange = z_lines[k] >= rotor.flange_lower_face && z_lines[k] < flange_top;
          materials(i, j, k)   = in_ring || in_flange ? ids::rotor : numbers::invalid_material_id;
        }

    SectorMesh mesh{empty_triangulation(communicator), form, n_teeth};
    Triangulation<3> &triangulation = *mesh.triangulation;
    GridGenerator::subdivided_hyper_rectangle(
        triangulation, {widths(r_lines), theta_widths, widths(z_lines)},
        Point<3>(r_lines.front(), first_angle, z_lines.front()), materials);
    set_boundary_ids(triangulation, rotor, form, first_angle, half_pitch);
    GridTools::transform([](const Point<3> &x)
                         { return Point<3>(x[0] * std::cos(x[1]), x[0] * std::sin(x[1]), x[2]); },
                         triangulation);
    triangulation.set_all_manifold_ids(0);
    triangulation.set_manifold(0, CylindricalManifold<3>(2));
    return mesh;
  }
} // namespace ringmotor
