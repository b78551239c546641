// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_sector.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    struct Range
    {
      double low  = std::numeric_limits<double>::max();
      double high = std::numeric_limits<double>::lowest();

      void add(const double value)
      {
        low  = std::min(low, value);
        high = std::max(high, value);
      }
      double at(const double share) const { return low + share * (high - low); }
    };

    /** The edges around the tooth's top, in (r, theta), where they are straight. */
    class Outline
    {
    public:
      /** The edge of one more face; those that two faces have are inside. */
      void add(const unsigned int vertex_a, const unsigned int vertex_b, const Point<3> &a,
               const Point<3> &b)
      {
        const auto key = std::minmax(vertex_a, vertex_b);
        if (!edges.emplace(key, std::make_pair(a, b)).second)
          edges.erase(key);
      }

      Range radii() const
      {
        Range range;
        for (const auto &[vertices, ends] : edges)
          for (const Point<3> &end : {ends.first, ends.second})
            range.add(end[0]);
        return range;
      }

      /** The angles at which it crosses radius @p r, in ascending order. */
      std::vector<double> angles_at(const double r) const { return crossings(0, r, 1); }
      /** From where to where it reaches at theta = 0, in r. */
      Range radii_at_center(const double tolerance) const
      {
        Range range;
        for (const double r : crossings(1, 0., 0))
          range.add(r);
        for (const auto &[vertices, ends] : edges) // along the mirror plane
          for (const Point<3> &end : {ends.first, ends.second})
            if (std::abs(end[1]) * end[0] <= tolerance)
              range.add(end[0]);
        return range;
      }

    private:
      std::vector<double> crossings(const unsigned int coordinate, const double value,
                                    const unsigned int other) const
      {
        std::vector<double> found;
        for (const auto &[vertices, ends] : edges)
        {
          const auto &[a, b] = ends;
          // An edge has its lower end, but not its upper one.
          if ((a[coordinate] <= value) != (b[coordinate] <= value))
          {
            const double share = (value - a[coordinate]) / (b[coordinate] - a[coordinate]);
            found.push_back(a[other] + share * (b[other] - a[other]));
          }
        }
        std::sort(found.begin(), found.end());
        return found;
      }

      std::map<std::pair<unsigned int, unsigned int>, std::pair<Point<3>, Point<3>>> edges;
    };

    class ToothCheck
    {
    public:
      ToothCheck(const SectorMesh &mesh, const MeshFile &file);

      void ceramic() const;
      void top() const;
      void foot() const;
      void shape() const;

    private:
      using Cell = Triangulation<3>::active_cell_iterator;
      using Face = Triangulation<3>::face_iterator;

      bool is_small(const double distance) const
      {
        return distance <= places::file_rounding * outer_radius;
      }
      template <typename Visit>
      void for_each_face(const Visit &visit) const
      {
        for (const auto &cell : mesh.triangulation->active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            visit(cell, face);
      }
      /** @p visit(cell of the tooth, face that it has in common with the base) */
      template <typename Visit>
      void for_each_face_of_foot(const Visit &visit) const
      {
        for (const auto &cell : mesh.triangulation->active_cell_iterators())
          for (const unsigned int face : cell->face_indices())
            if (cell->material_id() == ids::tooth && !cell->at_boundary(face) &&
                cell->neighbor(face)->material_id() == ids::base)
              visit(cell, cell->face(face));
      }
      /** ", near ..." */
      static std::string near(const Face &face)
      {
        return ", near " + in_words(cylindrical(face->center()));
      }
      bool is_marked(const Face &face) const
      {
        return face->at_boundary() && face->boundary_id() == ids::tooth_top;
      }
      bool is_at_top(const Face &face) const;
      bool is_on_cut(const Face &face) const;
      void add(const Face &face, Outline &outline) const
      {
        for (unsigned int i = 0; i < 4; ++i)
          outline.add(face->line(i)->vertex_index(0), face->line(i)->vertex_index(1),
                      cylindrical(face->line(i)->vertex(0)), cylindrical(face->line(i)->vertex(1)));
      }
      Outline outline_of_top() const;
      Outline outline_of_foot() const;
      void expect_two_ends(const std::string &name, const Outline &outline) const;
      void expect_reach(const std::string &name, const Outline &outline) const;
      void expect_center(const Outline &top) const;

      const SectorMesh &mesh;
      const MeshFile &file;
      const double outer_radius;
      Range height;                                  ///< of all
      std::map<types::material_id, Range> height_of; ///< by the id of the volume
      double height_of_cut = std::numeric_limits<double>::lowest();
    };

    const std::string name_of_top = "the tooth's top (physical id 15)";
    const std::string turn_the_mesh =
        "theta = 0 must be the centre of the tooth: turn the mesh around z";
    const std::string make_one_face =
        "it must be one face between an inner and an outer side, which are arcs around z, and two "
        "ends along r, with theta = 0 inside: correct the body or the physical ids";

    ToothCheck::ToothCheck(const SectorMesh &mesh, const MeshFile &file)
        : mesh(mesh), file(file), outer_radius(range_of_radii(*mesh.triangulation).second)
    {
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
      {
        for (const unsigned int i : cell->vertex_indices())
        {
          height.add(cell->vertex(i)[2]);
          height_of[cell->material_id()].add(cell->vertex(i)[2]);
        }
        for (const auto &face : cell->face_iterators())
          if (is_on_cut(face))
            for (const unsigned int i : face->vertex_indices())
              height_of_cut = std::max(height_of_cut, face->vertex(i)[2]);
      }
    }

    bool ToothCheck::is_at_top(const Face &face) const
    {
      const auto vertices = face->vertex_indices();
      return face->at_boundary() && std::all_of(vertices.begin(), vertices.end(),
                                                [&](const unsigned int i) {
                                                  return is_small(height.high - face->vertex(i)[2]);
                                                });
    }

    bool ToothCheck::is_on_cut(const Face &face) const
    {
      return face->at_boundary() && ids::is_cut(face->boundary_id());
    }

    void ToothCheck::ceramic() const
    {
      const auto ceramic = height_of.find(ids::piezoceramic);
      if (ceramic == height_of.end())
        return;
      const double highest = ceramic->second.high;
      if (!is_small(std::abs(highest)))
        file.refuse_place(std::abs(highest) / outer_radius,
                          "the piezoceramic (physical id 3) reaches up to z = " +
                              in_millimetres(highest),
                          "it must lie below the face at z = 0 where it is bonded to the base: "
                          "shift the mesh along z, turn it over, or correct the physical ids");
    }

    void ToothCheck::top() const
    {
      bool found = false;
      for_each_face(
          [&](const Cell &cell, const Face &face)
          {
            if (!is_marked(face))
              return;
            found = true;
            if (!is_at_top(face))
            {
              double lowest = height.high;
              for (const unsigned int i : face->vertex_indices())
                lowest = std::min(lowest, face->vertex(i)[2]);
              file.refuse_place((height.high - lowest) / outer_radius,
                                "a face of the tooth's top (physical id 15)" + near(face) +
                                    ", lies below the highest point of the body, z = " +
                                    in_millimetres(height.high),
                                "the tooth's top must be level, face +z and be the highest face of "
                                "all: correct the physical surface 15, or turn the mesh over");
            }
            if (cell->material_id() != ids::tooth)
              file.refuse("a face of the tooth's top (physical id 15)" + near(face) +
                              ", belongs to the physical volume " +
                              std::to_string(cell->material_id()),
                          "it must belong to the tooth (2): correct the physical ids");
          });
      if (!found)
        file.refuse("no face has the physical id 15 (tooth top)",
                    "mark the faces that can touch the rotor");
      for_each_face(
          [&](const Cell &, const Face &face)
          {
            if (!is_marked(face) && is_at_top(face))
              file.refuse("a face at the highest z" + near(face) +
                              ", belongs to the tooth's top but is not marked so",
                          "add it to the physical surface 15");
          });
    }

    void ToothCheck::foot() const
    {
      if (height_of.count(ids::base) == 0)
        file.refuse("no volume has the physical id 1 (base)",
                    "mark the metal below the slot's bottom as 1, the tooth above it as 2");
      Range foot;
      for_each_face_of_foot(
          [&](const Cell &tooth, const Face &face)
          {
            for (const unsigned int i : face->vertex_indices())
              foot.add(face->vertex(i)[2]);
            Tensor<1, 3> up = cross_product_3d(face->vertex(3) - face->vertex(0),
                                               face->vertex(2) - face->vertex(1));
            if (up * (tooth->center() - face->center()) < 0.)
              up *= -1.;
            if (up[2] < 0.5 * up.norm())
              file.refuse("the tooth (physical id 2) lies beside or below the base (1)" +
                              near(face),
                          "it must stand on the base at the slot's bottom: correct the physical "
                          "volumes");
          });
      if (foot.high < foot.low)
        file.refuse("no tooth cell (physical id 2) stands on a base cell (1)",
                    "mark the volumes of tooth and base");
      if (is_small(height.high - height_of_cut))
        return; // a ring without slots
      if (!is_small(std::max(0., foot.low - height_of_cut)))
        file.refuse_place((foot.low - height_of_cut) / outer_radius,
                          "the tooth (physical id 2) begins at z = " + in_millimetres(foot.low) +
                              ", above the slot's bottom at z = " + in_millimetres(height_of_cut),
                          "all metal above the slot's bottom must be marked as 2");
      for_each_face(
          [&](const Cell &cell, const Face &face)
          {
            if (cell->material_id() == ids::tooth && is_on_cut(face))
              file.refuse("the tooth (physical id 2) reaches a cut" + near(face),
                          "the metal below the slot's bottom must be marked as 1 (base)");
          });
    }

    Outline ToothCheck::outline_of_top() const
    {
      Outline outline;
      for_each_face(
          [&](const Cell &, const Face &face)
          {
            if (is_marked(face))
              add(face, outline);
          });
      return outline;
    }

    Outline ToothCheck::outline_of_foot() const
    {
      Outline outline;
      for_each_face_of_foot([&](const Cell &, const Face &face) { add(face, outline); });
      return outline;
    }

    void ToothCheck::shape() const
    {
      const Outline top = outline_of_top(), foot = outline_of_foot();
      expect_two_ends(name_of_top, top);
      expect_center(top);
      expect_reach(name_of_top, top);
      const std::string name_of_foot = "the tooth's foot, where physical volume 2 meets 1,";
      expect_two_ends(name_of_foot, foot);
      expect_reach(name_of_foot, foot);
    }

    void ToothCheck::expect_two_ends(const std::string &name, const Outline &outline) const
    {
      // Beyond roundings of its corners
      for (const double share : {0.02, 0.5, 0.98})
      {
        const double r                    = outline.radii().at(share);
        const std::vector<double> crossed = outline.angles_at(r);
        if (crossed.size() != 2)
          file.refuse(name + " begins or ends at " + std::to_string(crossed.size()) +
                          " angles at r = " + in_millimetres(r),
                      make_one_face);
      }
    }

    void ToothCheck::expect_reach(const std::string &name, const Outline &outline) const
    {
      const Range radii  = outline.radii();
      const Range inside = outline.radii_at_center(places::file_rounding * outer_radius);
      const double missing =
          std::max(std::abs(inside.low - radii.low), std::abs(radii.high - inside.high));
      if (!is_small(missing))
        file.refuse_place(missing / outer_radius,
                          name + " reaches from r = " + in_millimetres(radii.low) + " to " +
                              in_millimetres(radii.high) + ", but not at theta = 0",
                          make_one_face);
    }

    void ToothCheck::expect_center(const Outline &top) const
    {
      const double r                = top.radii().at(0.5);
      const std::vector<double> end = top.angles_at(r);
      const double width            = end[1] - end[0];
      const std::string found       = name_of_top + " reaches from " + in_degrees(end[0]) + " to " +
                                in_degrees(end[1]) + " at r = " + in_millimetres(r);
      // The edges are straight in (r, theta) between their nodes only, so that their middle is not
      // known to the digits of the file.
      constexpr double negligible = 1e-3;
      const bool is_ring   = is_small(std::abs(width - 2. * numbers::PI / mesh.n_sectors) * r);
      const double off     = mesh.form == SectorForm::half ? end[0] : 0.5 * (end[0] + end[1]);
      const bool is_center = mesh.form == SectorForm::half
                                 ? is_small(std::abs(off) * r)
                                 : is_ring || std::abs(off) <= negligible * width;
      if (!is_center)
        file.refuse_place(std::abs(off) * r / outer_radius, found, turn_the_mesh);
    }
  } // namespace

  void check_tooth(const SectorMesh &mesh, const MeshFile &file)
  {
    const ToothCheck check(mesh, file);
    check.top();
    check.foot();
    check.ceramic();
    check.shape();
  }
} // namespace ringmotor
