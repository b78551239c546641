// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/contact_line.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/merged_section.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/revolved.h>
#include <ringmotor/mesh/rotor_sector.h>
#include <ringmotor/mesh/section_layers.h>

#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Divides the contact line, what continues it outwards, and what it bounds. */
    void divide_contact(SectionGrading &cells, const RevolvedBody &rotor,
                        const InterfaceGrading &lip)
    {
      const Section &section = rotor.section;
      const double radius    = contact_line(rotor).radii.outer,
                   width     = contact_line(rotor).radii.width();
      unsigned int outermost = 0; // of the points in contact
      for (const Section::Edge &edge : section.edges_named(ids::lip))
      {
        unsigned int from = edge.first, to = edge.second;
        if (section.points[from][0] < section.points[to][0])
          std::swap(from, to);
        if (section.points[from][0] == radius)
          outermost = from;
        const double begin  = radius - section.points[from][0],
                     length = section.points[from][0] - section.points[to][0];
        std::vector<double> fractions; // where lines over the whole width divide this edge
        for (const double distance : lines_from_edge(width, lip.n_across, lip.ratio))
          if (const double fraction = (distance - begin) / length; fraction > 0. && fraction < 1.)
            fractions.push_back(fraction);
        cells.cut(from, to, fractions);
      }
      for (const Section::Across &edge : section.edges_across(ids::lip))
        cells.cut(edge.from, edge.to, lines_from_edge(1., lip.n_across + 1, lip.ratio));
      for (const auto &[edge, at_edge] : section.cells_at_edges())
        for (const auto &[from, to] : {edge, Section::Edge{edge.second, edge.first}})
          if (from == outermost && at_edge.size() == 1 && !section.is_named(edge, ids::lip) &&
              is_same_place(section.points[from][1], section.points[to][1], radius))
            cells.shrink(from, to, lip.n_across, lip.ratio);
    }

    Section divided(RevolvedBody rotor, const RotorGrading &grading, const InterfaceGrading &lip)
    {
      if (lip.n_across > 1)
        rotor.section = without_lines_from(ids::lip, rotor.section);
      SectionGrading cells(rotor.section);
      cells.grow_from(singular_points(rotor.section), grading.first,
                      {grading.ratio, grading.longest}, rotor.thinnest);
      if (lip.n_across > 1)
        divide_contact(cells, rotor, lip);
      return cells.result();
    }

    /** Lip and flange as a shell, tied to the solid root of the flange by its outer edge. */
    void add_flange_shell(SectorMesh &mesh, const RevolvedBody &rotor,
                          const std::vector<double> &angles, const RotorGrading &grading,
                          const InterfaceGrading &lip)
    {
      const Section::ShellLine &line = rotor.section.shell;
      std::vector<Point<2>> places{line.points.front()};
      std::vector<types::material_id> parts;
      for (unsigned int i = 0; i + 1 < line.points.size(); ++i)
      {
        const bool in_contact  = i < line.n_in_contact;
        const Point<2> &before = line.points[i], &end = line.points[i + 1];
        // Distances from the end, where the contact ends, too.
        std::vector<double> distances =
            in_contact ? lines_from_edge(1., std::max(grading.n_lip, lip.n_across), lip.ratio)
                       : lines_from_edge(1., grading.n_span, 1.);
        std::reverse(distances.begin(), distances.end());
        for (unsigned int j = 1; j < distances.size(); ++j)
        {
          places.push_back(end + distances[j] * (before - end));
          parts.push_back(in_contact ? ids::lip_shell : ids::rotor);
        }
      }
      std::vector<Point<3>> vertices;
      std::vector<CellData<2>> cells;
      const unsigned int n = angles.size();
      for (unsigned int i = 0; i < places.size(); ++i)
        for (unsigned int j = 0; j < n; ++j)
        {
          vertices.push_back(cartesian(Point<3>(places[i][0], angles[j], places[i][1])));
          if (i + 1 < places.size() && j + 1 < n)
          {
            CellData<2> cell;
            cell.vertices    = {i * n + j, (i + 1) * n + j, i * n + j + 1, (i + 1) * n + j + 1};
            cell.material_id = parts[i];
            cells.push_back(cell);
          }
        }
      add_shell(mesh, vertices, cells);
      const double root  = places.back()[0];
      const auto at_root = [&](const Point<3> &x)
      { return is_same_place(cylindrical(x)[0], root, root); };
      for (const auto &edge : mesh.shell->active_face_iterators())
        if (edge->at_boundary() && at_root(edge->vertex(0)) && at_root(edge->vertex(1)))
          edge->set_boundary_id(ids::shell_root);
      mesh.shell->set_all_manifold_ids(0);
      mesh.shell->set_manifold(0, CylindricalManifold<2, 3>(2));
      for (const types::material_id part : parts)
        mesh.sections[part] = {rotor.shell_thickness, 0.};
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

  SectorMesh make_rotor_sector(const RevolvedBody &rotor, const SectorForm form,
                               const RotorGrading &grading, MPI_Comm communicator,
                               const InterfaceGrading &lip)
  {
    Revolution revolution;
    revolution.form  = form;
    revolution.lines = lines_from_edge(1., lip.n_around, 1.);
    SectorMesh mesh  = revolve(divided(rotor, grading, lip), rotor.slots, revolution, communicator);
    if (!rotor.section.shell.points.empty())
    {
      std::vector<double> angles;
      for (const double place : revolution.lines)
        angles.push_back(place * rotor.slots.half_pitch());
      for (unsigned int i = 1; form == SectorForm::whole && i < revolution.lines.size(); ++i)
        angles.insert(angles.begin(), -revolution.lines[i] * rotor.slots.half_pitch());
      add_flange_shell(mesh, rotor, angles, grading, lip);
    }
    if (rotor.bar_stiffness > 0.)
      mesh.foundations[ids::radial_bars] = rotor.bar_stiffness;
    return mesh;
  }
} // namespace ringmotor
