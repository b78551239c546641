// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_sector.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    class SectorCheck
    {
    public:
      SectorCheck(const SectorMesh &mesh, const MeshFile &file);

      void half() const;
      void whole() const;

    private:
      using Vertices = std::map<unsigned int, Point<3>>;     ///< (r, theta, z) by vertex
      using Partners = std::map<unsigned int, unsigned int>; ///< vertices of the low cut by those
                                                             ///< of the high one

      Vertices vertices_on(const types::boundary_id boundary) const;
      void expect_plane(const types::boundary_id boundary, const double angle,
                        const std::string &name) const;
      Partners partners() const;
      void match_faces(const Partners &partners) const;
      void expect_all_in(const double lowest_angle, const double highest_angle) const;
      [[noreturn]] void refuse_unmarked(const Point<3> &place, const types::boundary_id id) const;
      void expect_marked(const types::boundary_id boundary, const double angle) const;
      void expect_turned_copies_marked() const;
      bool is_small(const double distance) const
      {
        return distance <= places::file_rounding * outer_radius;
      }
      /** Refuses it if @p distance (m) is more than the coordinates of a file may be off. */
      void expect_small(const double distance, const std::string &found,
                        const std::string &what_to_do) const
      {
        if (!is_small(distance))
          file.refuse_place(distance / outer_radius, found, what_to_do);
      }

      const SectorMesh &mesh;
      const Triangulation<3> &triangulation;
      const MeshFile &file;
      const double pitch;
      const double outer_radius;
    };

    const std::string make_turned_copy =
        "mesh one as a copy of the other, turned around z (Gmsh: Periodic Surface), and save all "
        "digits";

    SectorCheck::SectorCheck(const SectorMesh &mesh, const MeshFile &file)
        : mesh(mesh), triangulation(*mesh.triangulation), file(file),
          pitch(2. * numbers::PI / mesh.n_sectors),
          outer_radius(range_of_radii(triangulation).second)
    {
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
        expect_small(std::abs(vertex[1] - angle) * vertex[0],
                     "a node of the " + name + " (physical id " + std::to_string(boundary) +
                         ") lies at " + in_words(vertex),
                     "all must lie at " + in_degrees(angle) +
                         " for Motor/Number of teeth = " + std::to_string(mesh.n_sectors) +
                         ": rotate the mesh or correct the number of teeth");
    }

    void SectorCheck::half() const
    {
      expect_plane(ids::mirror, 0., "mirror plane");
      expect_plane(ids::cut, 0.5 * pitch, "cut");
      expect_all_in(0., 0.5 * pitch);
      expect_marked(ids::mirror, 0.);
      expect_marked(ids::cut, 0.5 * pitch);
    }

    /** Of two places (r, theta, z) in the plane (r, z). */
    double meridional_distance(const Point<3> &a, const Point<3> &b)
    {
      return std::max(std::abs(a[0] - b[0]), std::abs(a[2] - b[2]));
    }

    SectorCheck::Partners SectorCheck::partners() const
    {
      const Vertices low = vertices_on(ids::cut_low), high = vertices_on(ids::cut_high);
      Partners partners;
      std::map<unsigned int, unsigned int> partner_of_low;
      for (const auto &[index, vertex] : high)
      {
        const auto partner = std::min_element(
            low.begin(), low.end(),
            [&at = vertex](const auto &a, const auto &b)
            { return meridional_distance(a.second, at) < meridional_distance(b.second, at); });
        expect_small(meridional_distance(partner->second, vertex),
                     "the two cuts (physical ids 13 and 14) do not match: the node of 14 at " +
                         in_words(vertex) + " has no partner on 13",
                     make_turned_copy);
        const auto [other, is_new] = partner_of_low.emplace(partner->first, index);
        if (!is_new)
          file.refuse("the cut (physical id 14) has two nodes at the same r and z, at " +
                          in_words(vertex) + " and at " + in_words(high.at(other->second)),
                      "let the cut have each r and z once");
        const double turn = vertex[1] - partner->second[1];
        expect_small(std::abs(turn - pitch) * vertex[0],
                     "the angle from the cut 13 to the cut 14 is " + in_degrees(turn),
                     "it must be " + in_degrees(pitch) +
                         " for Motor/Number of teeth = " + std::to_string(mesh.n_sectors) +
                         ", with theta = 0 in between: correct the mesh or the number of teeth");
        partners[index] = partner->first;
      }
      if (low.size() != high.size())
        file.refuse("the two cuts (physical ids 13 and 14) do not match: they have " +
                        std::to_string(low.size()) + " and " + std::to_string(high.size()) +
                        " nodes",
                    make_turned_copy);
      return partners;
    }

    void SectorCheck::match_faces(const Partners &partners) const
    {
      std::array<std::set<std::set<unsigned int>>, 2> faces; // of the low cut, by their vertices
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() &&
              (face->boundary_id() == ids::cut_low || face->boundary_id() == ids::cut_high))
          {
            const bool is_high = face->boundary_id() == ids::cut_high;
            std::set<unsigned int> vertices;
            for (const unsigned int i : face->vertex_indices())
              vertices.insert(is_high ? partners.at(face->vertex_index(i)) : face->vertex_index(i));
            faces[is_high].insert(vertices);
          }
      if (faces[0] != faces[1])
        file.refuse("the two cuts (physical ids 13 and 14) do not match: their nodes do, but are "
                    "joined to different faces",
                    make_turned_copy);
    }

    void SectorCheck::whole() const
    {
      match_faces(partners());
      std::array<double, 2> bound{{numbers::PI, -numbers::PI}};
      for (const auto &vertex : vertices_on(ids::cut_low))
        bound[0] = std::min(bound[0], vertex.second[1]);
      for (const auto &vertex : vertices_on(ids::cut_high))
        bound[1] = std::max(bound[1], vertex.second[1]);
      if (bound[0] >= 0. || bound[1] <= 0.)
        file.refuse("the sector reaches from " + in_degrees(bound[0]) + " to " +
                        in_degrees(bound[1]),
                    "turn it so that theta = 0 is the tooth's centre");
      expect_all_in(bound[0], bound[1]);
      expect_turned_copies_marked();
    }

    void SectorCheck::expect_all_in(const double lowest_angle, const double highest_angle) const
    {
      for (const Point<3> &vertex : triangulation.get_vertices())
      {
        const Point<3> p = cylindrical(vertex);
        expect_small(std::max(lowest_angle - p[1], p[1] - highest_angle) * p[0],
                     "the node at " + in_words(p) +
                         " lies outside the sector, which reaches from " +
                         in_degrees(lowest_angle) + " to " + in_degrees(highest_angle),
                     "give one sector only, with theta = 0 at the tooth's centre");
      }
    }

    void SectorCheck::refuse_unmarked(const Point<3> &place, const types::boundary_id id) const
    {
      file.refuse("a surface near " + in_words(place) +
                      " lies on a cut or the mirror plane but is not marked so",
                  "add it to the physical surface " + std::to_string(id));
    }

    void SectorCheck::expect_marked(const types::boundary_id boundary, const double angle) const
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() != boundary)
          {
            const auto vertices = face->vertex_indices();
            if (std::all_of(vertices.begin(), vertices.end(),
                            [&](const unsigned int i)
                            {
                              const Point<3> p = cylindrical(face->vertex(i));
                              return is_small(std::abs(p[1] - angle) * p[0]);
                            }))
              refuse_unmarked(cylindrical(face->center()), boundary);
          }
    }

    void SectorCheck::expect_turned_copies_marked() const
    {
      std::multimap<double, Point<3>> others; // by theta
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() != ids::cut_low &&
              face->boundary_id() != ids::cut_high)
          {
            const Point<3> center = cylindrical(face->center());
            others.emplace(center[1], center);
          }
      for (const auto &[theta, center] : others)
      {
        const double reach = places::file_rounding * outer_radius / center[0];
        const auto end     = others.upper_bound(theta + pitch + reach);
        for (auto other = others.lower_bound(theta + pitch - reach); other != end; ++other)
          if (is_small(meridional_distance(other->second, center)))
            refuse_unmarked(center, ids::cut_low);
      }
    }
  } // namespace

  void check_cuts(const SectorMesh &mesh, const MeshFile &file)
  {
    const SectorCheck check(mesh, file);
    if (mesh.form == SectorForm::half)
      check.half();
    else
      check.whole();
  }
} // namespace ringmotor
