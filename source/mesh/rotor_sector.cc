// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/graded_lines.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
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
    /** The cells at the edges where flange and ring meet. */
    struct EdgeCells
    {
      double first;          ///< width, m
      double ratio, longest; ///< see RotorGrading
    };

    /** Lines from @p from to @p to, finer at @p from, which is not included. */
    void append_lines(std::vector<double> &lines, const double from, const double to,
                      const EdgeCells &cells)
    {
      const std::vector<double> distances =
          graded_lines(std::abs(to - from), cells.first, cells.ratio, cells.longest);
      for (unsigned int i = 1; i < distances.size(); ++i)
        lines.push_back(from + (to > from ? distances[i] : -distances[i]));
    }

    /**
     * Lines across flange and lip, without those of the ring: finer at the ring and, for contact,
     * on both sides of the lip's outer edge.
     */
    void append_flange_lines(std::vector<double> &lines, const RotorGeometry &rotor,
                             const EdgeCells &cells, const InterfaceGrading &lip)
    {
      for (const double distance : lines_from_edge(rotor.lip_outer_radius - rotor.lip_inner_radius,
                                                   lip.n_across, lip.ratio))
        lines.push_back(rotor.lip_outer_radius - distance);
      if (lip.n_across == 1)
      {
        lines.pop_back();
        lines.back() = rotor.lip_inner_radius;
        append_lines(lines, rotor.ring_inner_radius, rotor.lip_outer_radius, cells);
        return;
      }
      const double middle = 0.5 * (rotor.lip_outer_radius + rotor.ring_inner_radius);
      append_lines(lines, rotor.ring_inner_radius, middle, cells);
      const std::vector<double> distances =
          lines_from_edge(middle - rotor.lip_outer_radius, lip.n_across, lip.ratio);
      for (unsigned int i = 1; i + 1 < distances.size(); ++i)
        lines.push_back(rotor.lip_outer_radius + distances[i]);
    }

    std::vector<double> sorted(std::vector<double> lines)
    {
      std::sort(lines.begin(), lines.end());
      return lines;
    }

    /**
     * Where a flange that is a shell begins: half its thickness away from the ring. The stresses in
     * the corners at the ring, which a shell cannot represent, have decayed there.
     */
    double root_radius(const RotorGeometry &rotor)
    {
      return rotor.flange_element == ElementKind::shell
                 ? rotor.ring_inner_radius - 0.5 * rotor.flange_thickness
                 : rotor.ring_inner_radius;
    }

    /** Sets the boundary ids while the mesh is still the box of cylindrical coordinates (r, theta,
     * z). */
    void set_boundary_ids(Triangulation<3> &box, const RotorGeometry &rotor, const SectorForm form,
                          const std::vector<double> &angles)
    {
      const auto at = [&](const double a, const double b)
      { return is_same_place(a, b, rotor.ring_outer_radius); };
      const auto at_angle = [](const double a, const double b) { return is_same_place(a, b, 1.); };
      for (const auto &cell : box.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
          {
            const Point<3> center = face->center();
            const bool level =
                at(face->vertex(0)[2], face->vertex(3)[2]) && at(face->vertex(0)[2], center[2]);
            types::boundary_id id = ids::free;
            if (at_angle(center[1], angles.back()))
              id = form == SectorForm::half ? ids::cut : ids::cut_high;
            else if (at_angle(center[1], angles.front()))
              id = form == SectorForm::half ? ids::mirror : ids::cut_low;
            else if (level && at(center[2], rotor.ring_upper_face))
              id = ids::ring_top;
            else if (level && at(center[2], rotor.flange_lower_face) &&
                     center[0] < rotor.lip_outer_radius)
              id = ids::lip;
            else if (at(center[0], root_radius(rotor)) &&
                     rotor.flange_element == ElementKind::shell)
              id = ids::shell_root;
            else if (at(center[0], rotor.ring_inner_radius))
              id = center[2] > rotor.ring_upper_face - rotor.radial_bar_height ? ids::radial_bars
                                                                               : ids::ring_bore;
            face->set_boundary_id(id);
          }
    }

    /** The box of cylindrical coordinates, bent around the axis. */
    Point<3> bent(const Point<3> &x)
    {
      return Point<3>(x[0] * std::cos(x[1]), x[0] * std::sin(x[1]), x[2]);
    }

    /** Lip and flange as a shell, tied to the solid root of the flange by its outer edge. */
    void add_flange_shell(SectorMesh &mesh, const RotorGeometry &rotor,
                          const std::vector<double> &angles, const RotorGrading &grading,
                          const InterfaceGrading &lip)
    {
      const double height      = rotor.flange_lower_face + 0.5 * rotor.flange_thickness;
      const unsigned int n_lip = std::max(grading.n_lip, lip.n_across), n_span = grading.n_span;
      std::vector<double> radii;
      for (const double distance :
           lines_from_edge(rotor.lip_outer_radius - rotor.lip_inner_radius, n_lip, lip.ratio))
        radii.insert(radii.begin(), rotor.lip_outer_radius - distance);
      for (unsigned int i = 1; i <= n_span; ++i)
        radii.push_back(rotor.lip_outer_radius +
                        i * (root_radius(rotor) - rotor.lip_outer_radius) / n_span);

      std::vector<Point<3>> vertices;
      std::vector<CellData<2>> cells;
      const unsigned int n = angles.size();
      for (unsigned int i = 0; i < radii.size(); ++i)
        for (unsigned int j = 0; j < n; ++j)
        {
          vertices.push_back(bent(Point<3>(radii[i], angles[j], height)));
          if (i + 1 < radii.size() && j + 1 < n)
          {
            CellData<2> cell;
            cell.vertices    = {i * n + j, (i + 1) * n + j, i * n + j + 1, (i + 1) * n + j + 1};
            cell.material_id = i < n_lip ? ids::lip_shell : ids::rotor;
            cells.push_back(cell);
          }
        }
      add_shell(mesh, vertices, cells);
      for (const auto &cell : mesh.shell->active_cell_iterators())
        for (const auto &edge : cell->face_iterators())
          if (const auto at_root =
                  [&](const unsigned int i) {
                    return is_same_place(cylindrical(edge->vertex(i))[0], root_radius(rotor),
                                         root_radius(rotor));
                  };
              edge->at_boundary() && at_root(0) && at_root(1))
            edge->set_boundary_id(ids::shell_root);
      mesh.shell->set_all_manifold_ids(0);
      mesh.shell->set_manifold(0, CylindricalManifold<2, 3>(2));
      mesh.sections[ids::rotor] = mesh.sections[ids::lip_shell] = {rotor.flange_thickness, 0.};
    }

    /** The lines of the cross-section along r. */
    std::vector<double> radial_lines(const RotorGeometry &rotor, const EdgeCells &cells,
                                     const InterfaceGrading &lip)
    {
      std::vector<double> r_lines{rotor.ring_inner_radius};
      if (rotor.flange_element == ElementKind::solid)
        append_flange_lines(r_lines, rotor, cells, lip);
      else
        append_lines(r_lines, rotor.ring_inner_radius, root_radius(rotor), cells);
      append_lines(r_lines, rotor.ring_inner_radius, rotor.ring_outer_radius, cells);
      return sorted(r_lines);
    }

    double flange_top(const RotorGeometry &rotor)
    {
      return rotor.flange_lower_face + rotor.flange_thickness;
    }

    /** Those along z. */
    std::vector<double> axial_lines(const RotorGeometry &rotor, const EdgeCells &cells,
                                    const InterfaceGrading &lip)
    {
      const double flange_top    = ringmotor::flange_top(rotor);
      const double flange_middle = 0.5 * (rotor.flange_lower_face + flange_top);
      std::vector<double> z_lines{rotor.flange_lower_face, flange_top};
      append_lines(z_lines, rotor.flange_lower_face, rotor.ring_lower_face, cells);
      if (rotor.flange_element == ElementKind::solid && lip.n_across > 1)
      {
        for (const double distance :
             lines_from_edge(rotor.flange_thickness, lip.n_across + 1, lip.ratio))
          z_lines.push_back(rotor.flange_lower_face + distance);
      }
      else
      {
        append_lines(z_lines, rotor.flange_lower_face, flange_middle, cells);
        append_lines(z_lines, flange_top, flange_middle, cells);
      }
      append_lines(z_lines, flange_top, rotor.ring_upper_face - rotor.radial_bar_height, cells);
      z_lines.push_back(rotor.ring_upper_face);
      z_lines = sorted(z_lines);
      // The flange was added from both sides.
      z_lines.erase(std::unique(z_lines.begin(), z_lines.end(),
                                [&](const double a, const double b)
                                { return is_same_place(a, b, rotor.ring_outer_radius); }),
                    z_lines.end());
      return z_lines;
    }
  } // namespace

  RotorGrading RotorGrading::level(const unsigned int level)
  {
    RotorGrading grading;
    grading.first *= std::pow(grading.ratio, level);
    grading.n_span += level;
    grading.n_lip += level / 2;
    return grading;
  }

  SectorMesh make_rotor_sector(const RotorGeometry &rotor, const unsigned int n_teeth,
                               const SectorForm form, const RotorGrading &grading,
                               MPI_Comm communicator, const InterfaceGrading &lip)
  {
    const EdgeCells cells{grading.first * rotor.flange_thickness, grading.ratio, grading.longest};
    const std::vector<double> r_lines = radial_lines(rotor, cells, lip),
                              z_lines = axial_lines(rotor, cells, lip);

    const double half_pitch = numbers::PI / n_teeth;
    std::vector<double> angles;
    const int n_around = static_cast<int>(lip.n_around);
    for (int i = form == SectorForm::whole ? -n_around : 0; i <= n_around; ++i)
      angles.push_back(i * half_pitch / n_around);
    const std::vector<double> theta_widths = widths(angles);

    Table<3, types::material_id> materials(r_lines.size() - 1, theta_widths.size(),
                                           z_lines.size() - 1);
    for (unsigned int i = 0; i + 1 < r_lines.size(); ++i)
      for (unsigned int j = 0; j < theta_widths.size(); ++j)
        for (unsigned int k = 0; k + 1 < z_lines.size(); ++k)
        {
          const bool in_ring = r_lines[i] >= rotor.ring_inner_radius;
          const bool in_flange =
              z_lines[k] >= rotor.flange_lower_face && z_lines[k] < flange_top(rotor);
          materials(i, j, k) = in_ring || in_flange ? ids::rotor : numbers::invalid_material_id;
        }

    SectorMesh mesh;
    mesh.triangulation              = empty_triangulation<3>(communicator);
    mesh.form                       = form;
    mesh.n_sectors                  = n_teeth;
    Triangulation<3> &triangulation = *mesh.triangulation;
    GridGenerator::subdivided_hyper_rectangle(
        triangulation, {widths(r_lines), theta_widths, widths(z_lines)},
        Point<3>(r_lines.front(), angles.front(), z_lines.front()), materials);
    set_boundary_ids(triangulation, rotor, form, angles);
    GridTools::transform(bent, triangulation);
    triangulation.set_all_manifold_ids(0);
    triangulation.set_manifold(0, CylindricalManifold<3>(2));
    if (rotor.flange_element != ElementKind::solid)
      add_flange_shell(mesh, rotor, angles, grading, lip);
    if (rotor.radial_bar_stiffness > 0.)
      mesh.foundations[ids::radial_bars] = rotor.radial_bar_stiffness / rotor.radial_bar_height;
    return mesh;
  }
} // namespace ringmotor
