// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_sector.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/parameters/prm_file.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** (r, theta, z) with theta in (-pi, pi]. */
    Point<3> cylindrical(const Point<3> &position)
    {
      return Point<3>(std::hypot(position[0], position[1]), std::atan2(position[1], position[0]),
                      position[2]);
    }

    std::string text(const double number)
    {
      std::ostringstream out;
      out.precision(8);
      out << number;
      return out.str();
    }

    std::string in_degrees(const double angle)
    {
      return text(angle * 180. / numbers::PI) + " degrees";
    }

    std::string place(const Point<3> &p)
    {
      return "r = " + text(1e3 * p[0]) + " mm, theta = " + in_degrees(p[1]) +
             ", z = " + text(1e3 * p[2]) + " mm";
    }

    class SectorCheck
    {
    public:
      SectorCheck(const SectorMesh &mesh, const std::string &file);

      void size() const;
      void one_piece() const;
      void half() const;
      void whole() const;
      void inside_and_marked() const;
      void cell_shapes() const;

    private:
      using Vertices = std::map<unsigned int, Point<3>>; ///< (r, theta, z) by vertex

      [[noreturn]] void refuse(const std::string &found, const std::string &what_to_do) const
      {
        throw mesh_file_error(file, found, what_to_do);
      }
      Vertices vertices_on(const types::boundary_id boundary) const;
      void expect_plane(const types::boundary_id boundary, const double angle,
                        const std::string &name) const;

      const SectorMesh &mesh;
      const Triangulation<3> &triangulation;
      const std::string &file;
      const double pitch;
      double inner_radius, outer_radius;
      double tolerance; ///< m, between points that must coincide
    };

    SectorCheck::SectorCheck(const SectorMesh &mesh, const std::string &file)
        : mesh(mesh), triangulation(*mesh.triangulation), file(file),
          pitch(2. * numbers::PI / mesh.n_sectors)
    {
      std::vector<double> radii;
      for (const Point<3> &vertex : triangulation.get_vertices())
        radii.push_back(cylindrical(vertex)[0]);
      inner_radius = *std::min_element(radii.begin(), radii.end());
      outer_radius = *std::max_element(radii.begin(), radii.end());
      tolerance    = 1e-7 * outer_radius;
    }

    void SectorCheck::size() const
    {
      // Ring motors have radii from about a tenth of a millimetre to some decimetres.
      if (outer_radius - tolerance > 1.)
        refuse("its largest radius is " + text(outer_radius) + " m",
               "lengths are in m, and motors larger than 1 m are not expected: if the mesh is in "
               "mm, scale it (Gmsh: Mesh.ScalingFactor = 0.001)");
      if (outer_radius < 5e-5)
        refuse("its largest radius is " + text(1e6 * outer_radius) + " um",
               "lengths are in m, and motors smaller than 50 um are not expected: check the scale "
               "(Gmsh: Mesh.ScalingFactor)");
      if (inner_radius < 1e-3 * outer_radius)
        refuse("it reaches the axis of rotation, which is the z axis (smallest radius " +
                   text(1e3 * inner_radius) + " mm, largest " + text(1e3 * outer_radius) + " mm)",
               "move the mesh so that z is the axis of the ring, or leave a hole");
    }

    void SectorCheck::one_piece() const
    {
      auto [vertices, cells, faces] = GridTools::get_coarse_mesh_description(triangulation);
      std::vector<unsigned int> all;
      GridTools::delete_duplicated_vertices(vertices, cells, faces, all, tolerance);
      if (vertices.size() < triangulation.n_used_vertices())
        refuse("parts touch without sharing their nodes (" +
                   std::to_string(triangulation.n_used_vertices() - vertices.size()) +
                   " nodes lie on others)",
               "glue the volumes before meshing (Gmsh: Coherence, or BooleanFragments)");

      std::vector<unsigned int> n_cells_at(triangulation.n_raw_faces(), 0);
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
        {
          if (++n_cells_at[cell->face_index(face)] > 2)
            refuse(
                "more than two cells meet at one face, near " +
                    place(cylindrical(cell->face(face)->center())),
                "remove the cells that lie on others, and give each volume one physical id only");
          if (!cell->at_boundary(face))
            waiting.push_back(cell->neighbor(face));
        }
      }
      if (n_reached < triangulation.n_active_cells())
        refuse("the body is in pieces: only " + std::to_string(n_reached) + " of its " +
                   std::to_string(triangulation.n_active_cells()) + " cells are connected",
               "let neighbouring volumes share a surface (Gmsh: Coherence, or BooleanFragments)");
    }

    SectorCheck::Vertices SectorCheck::vertices_on(const types::boundary_id boundary) const
    {
      Vertices found;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == boundary)
            for (const unsigned int i : face->vertex_indices())
              found[face->vertex_index(i)] = cylindrical(face->vertex(i));
      return found;
    }

    void SectorCheck::expect_plane(const types::boundary_id boundary, const double angle,
                                   const std::string &name) const
    {
      for (const auto &[index, vertex] : vertices_on(boundary))
        if (std::abs(vertex[1] - angle) * vertex[0] > tolerance)
          refuse("a node of the " + name + " (physical id " + std::to_string(boundary) +
                     ") lies at " + place(vertex),
                 "all must lie at " + in_degrees(angle) +
                     " for Motor/Number of teeth = " + std::to_string(mesh.n_sectors) +
                     ": rotate the mesh or correct the number of teeth");
    }

    void SectorCheck::half() const
    {
      expect_plane(ids::mirror, 0., "mirror plane");
      expect_plane(ids::cut, 0.5 * pitch, "cut");
    }

    void SectorCheck::whole() const
    {
      const Vertices low = vertices_on(ids::cut_low), high = vertices_on(ids::cut_high);
      const std::string mend = "mesh one as a copy of the other, turned around z (Gmsh: Periodic "
                               "Surface), and save all digits";
      for (const auto &[index, vertex] : high)
      {
        const auto partner = std::find_if(low.begin(), low.end(),
                                          [&, &at = vertex](const auto &other)
                                          {
                                            return std::abs(other.second[0] - at[0]) <= tolerance &&
                                                   std::abs(other.second[2] - at[2]) <= tolerance;
                                          });
        if (partner == low.end())
          refuse("the two cuts (physical ids 13 and 14) do not match: the node of 14 at " +
                     place(vertex) + " has no partner on 13",
                 mend);
        const double turn = vertex[1] - partner->second[1];
        if (std::abs(turn - pitch) * vertex[0] > tolerance)
          refuse("the angle from the cut 13 to the cut 14 is " + in_degrees(turn),
                 "it must be " + in_degrees(pitch) +
                     " for Motor/Number of teeth = " + std::to_string(mesh.n_sectors) +
                     ", with theta = 0 in between: correct the mesh or the number of teeth");
      }
      if (low.size() != high.size())
        refuse("the two cuts (physical ids 13 and 14) do not match: they have " +
                   std::to_string(low.size()) + " and " + std::to_string(high.size()) + " nodes",
               mend);
    }

    void SectorCheck::inside_and_marked() const
    {
      const bool is_half = mesh.form == SectorForm::half;
      const std::array<types::boundary_id, 2> cut_ids{
          {is_half ? ids::mirror : ids::cut_low, is_half ? ids::cut : ids::cut_high}};
      std::array<double, 2> bound{{numbers::PI, -numbers::PI}};
      for (const auto &vertex : vertices_on(cut_ids[0]))
        bound[0] = std::min(bound[0], vertex.second[1]);
      for (const auto &vertex : vertices_on(cut_ids[1]))
        bound[1] = std::max(bound[1], vertex.second[1]);

      if (!is_half && (bound[0] >= 0. || bound[1] <= 0.))
        refuse("the sector reaches from " + in_degrees(bound[0]) + " to " + in_degrees(bound[1]),
               "turn it so that theta = 0 is the tooth's centre");
      for (const Point<3> &vertex : triangulation.get_vertices())
      {
        const Point<3> p = cylindrical(vertex);
        if ((bound[0] - p[1]) * p[0] > tolerance || (p[1] - bound[1]) * p[0] > tolerance)
          refuse("the node at " + place(p) + " lies outside the sector, which reaches from " +
                     in_degrees(bound[0]) + " to " + in_degrees(bound[1]),
                 "give one sector only, with theta = 0 at the tooth's centre");
      }
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          for (unsigned int side = 0; side < 2 && face->at_boundary(); ++side)
          {
            const auto vertices = face->vertex_indices();
            const bool in_plane =
                std::all_of(vertices.begin(), vertices.end(),
                            [&](const unsigned int i)
                            {
                              const Point<3> p = cylindrical(face->vertex(i));
                              return std::abs(p[1] - bound[side]) * p[0] <= tolerance;
                            });
            if (in_plane && face->boundary_id() != cut_ids[side])
              refuse("a surface near " + place(cylindrical(face->center())) +
                         " lies on a cut or the mirror plane but is not marked so",
                     "add it to the physical surface " + std::to_string(cut_ids[side]));
          }
    }

    void SectorCheck::cell_shapes() const
    {
      // 1 at right angles, 0 where edges are parallel, negative where the cell is turned inside out
      const double least_sine = 1e-3;
      const MappingQ<3> mapping(2);
      const FE_Nothing<3> nothing;
      // The corners matter too: there it is worst.
      FEValues<3> inside(mapping, nothing, QGauss<3>(3), update_jacobians),
          corners(mapping, nothing, QTrapezoid<3>(), update_jacobians);
      for (const auto &cell : triangulation.active_cell_iterators())
        for (FEValues<3> *const values : {&inside, &corners})
        {
          values->reinit(cell);
          for (const auto &jacobian : values->get_jacobians())
          {
            const auto edges    = jacobian.transpose();
            const double volume = edges[0].norm() * edges[1].norm() * edges[2].norm();
            if (!(jacobian.determinant() > least_sine * volume))
              refuse("the cell at " + place(cylindrical(cell->center())) +
                         " is inverted or has no volume",
                     "repair the mesh");
          }
        }
    }
  } // namespace

  UserError mesh_file_error(const std::string &file, const std::string &found,
                            const std::string &what_to_do)
  {
    return UserError("Stator/Mesh file = " + in_quotes(file) + ": " + found + "; " + what_to_do);
  }

  void check_sector(const SectorMesh &mesh, const std::string &file)
  {
    const SectorCheck check(mesh, file);
    check.size();
    check.cell_shapes();
    check.one_piece();
    if (mesh.form == SectorForm::half)
      check.half();
    else
      check.whole();
    check.inside_and_marked();
  }
} // namespace ringmotor
