// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/contact_surface.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/mirror.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The place of a unit point between corners, bilinear in r and theta. */
    Point<2> place_of(const std::array<Point<2>, 4> &corner, const Point<2> &unit)
    {
      const double u = unit[0], v = unit[1];
      return Point<2>((1. - u) * (1. - v) * corner[0] + u * (1. - v) * corner[1] +
                      (1. - u) * v * corner[2] + u * v * corner[3]);
    }
  } // namespace

  Point<2> unit_point(const std::array<Point<2>, 4> &corner, const Point<2> &x)
  {
    Point<2> unit(0.5, 0.5);
    for (unsigned int step = 0; step < 20; ++step)
    {
      const double u = unit[0], v = unit[1];
      const Tensor<1, 2> miss  = place_of(corner, unit) - x;
      const Tensor<1, 2> by_u  = (1. - v) * (corner[1] - corner[0]) + v * (corner[3] - corner[2]),
                         by_v  = (1. - u) * (corner[2] - corner[0]) + u * (corner[3] - corner[1]);
      const double determinant = by_u[0] * by_v[1] - by_u[1] * by_v[0];
      unit[0] -= (miss[0] * by_v[1] - miss[1] * by_v[0]) / determinant;
      unit[1] -= (by_u[0] * miss[1] - by_u[1] * miss[0]) / determinant;
    }
    return unit;
  }

  SurfaceWeights interpolation(const ContactSurface &surface, const Point<2> &place)
  {
    double least = std::numeric_limits<double>::infinity();
    Point<2> unit;
    unsigned int nearest = 0;
    for (unsigned int face = 0; face < surface.faces.size(); ++face)
    {
      const Point<2> found = unit_point(surface.corners[face], place);
      const double outside = GeometryInfo<2>::distance_to_unit_cell(found);
      if (outside < least)
      {
        least   = outside;
        unit    = GeometryInfo<2>::project_to_unit_cell(found);
        nearest = face;
      }
    }
    const FE_Q<2> element(surface.degree);
    SurfaceWeights weights;
    for (unsigned int i = 0; i < surface.faces[nearest].size(); ++i)
      weights.emplace_back(surface.faces[nearest][i], element.shape_value(i, unit));
    return weights;
  }

  namespace
  {
    Point<2> in_plane(const Point<3> &x)
    {
      return Point<2>(std::hypot(x[0], x[1]), std::atan2(x[1], x[0]));
    }

    /** Unit vectors of a point vector's components at a place: z, -theta, r. */
    std::array<Tensor<1, 3>, 3> directions(const Point<3> &x)
    {
      const double r = std::hypot(x[0], x[1]);
      std::array<Tensor<1, 3>, 3> axes;
      axes[0][2] = 1.;
      axes[1][0] = x[1] / r;
      axes[1][1] = -x[0] / r;
      axes[2][0] = x[0] / r;
      axes[2][1] = x[1] / r;
      return axes;
    }

    /** A node of a face, known by a key, and where it is on the unit face. */
    struct FaceNode
    {
      unsigned int key;
      Point<2> unit;
      SurfaceNode node;
    };

    /** Between places in (r, theta), m. */
    double distance(const Point<2> &a, const Point<2> &b)
    {
      return std::hypot(a[0] - b[0], a[0] * (a[1] - b[1]));
    }

    double longest_side(const std::array<Point<2>, 4> &corner)
    {
      double longest = 0.;
      for (const auto &[a, b] : {std::pair(0, 1), {0, 2}, {1, 3}, {2, 3}})
        longest = std::max(longest, distance(corner[a], corner[b]));
      return longest;
    }

    /** Collects faces, each node once. */
    class SurfaceBuilder
    {
    public:
      explicit SurfaceBuilder(const unsigned int degree) : element(degree)
      {
        surface.degree = degree;
      }

      /** @param corner in (r, theta), by vertices of the unit face */
      void add_face(std::array<Point<2>, 4> corner, std::vector<FaceNode> nodes)
      {
        // The local axes shall be a right-handed system in (r, theta).
        const Tensor<1, 2> a = corner[1] - corner[0], b = corner[2] - corner[0];
        if (a[0] * b[1] - a[1] * b[0] < 0.)
        {
          std::swap(corner[1], corner[2]);
          for (FaceNode &node : nodes)
            node.unit = Point<2>(node.unit[1], node.unit[0]);
        }
        std::vector<unsigned int> face(element.n_dofs_per_cell(), numbers::invalid_unsigned_int);
        constexpr double most = 0.1; // of the longest side, from where the corners have a node
        const double farthest = most * longest_side(corner);
        for (const FaceNode &node : nodes)
        {
          if (distance(place_of(corner, node.unit), node.node.place) > farthest)
            throw UserError("a face that can touch is too distorted for contact; make it more like "
                            "a rectangle in r and theta (Stator/Mesh file, Rotor/Mesh file)");
          const auto [entry, is_new] = number.emplace(node.key, surface.nodes.size());
          if (is_new)
            surface.nodes.push_back(node.node);
          for (unsigned int j = 0; j < face.size(); ++j)
            if (element.unit_support_point(j).distance(node.unit) < 1e-10)
              face[j] = entry->second;
        }
        surface.corners.push_back(corner);
        surface.faces.push_back(face);
      }

      ContactSurface surface;

    private:
      const FE_Q<2> element;
      std::map<unsigned int, unsigned int> number;
    };
  } // namespace

  ContactSurface solid_surface(const SectorElements &sector, const types::boundary_id faces)
  {
    const FiniteElement<3> &fe = sector.dofs().get_fe();
    const SectorNodes &nodes   = sector.nodes();
    SurfaceBuilder builder(fe.degree);
    for (const auto &cell : sector.dofs().active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f) && cell->face(f)->boundary_id() == faces)
        {
          std::array<Point<3>, 4> unit_vertices;
          std::array<Point<2>, 4> vertices;
          for (unsigned int v = 0; v < 4; ++v)
          {
            const unsigned int vertex = GeometryInfo<3>::face_to_cell_vertices(f, v);
            unit_vertices[v]          = GeometryInfo<3>::unit_cell_vertex(vertex);
            vertices[v]               = in_plane(cell->vertex(vertex));
          }
          const std::vector<SectorNodes::Dof> dofs = sector.dofs_of(cell);
          std::vector<FaceNode> found;
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (fe.system_to_component_index(i).first == 0 && fe.has_support_on_face(i, f))
            {
              const unsigned int node   = nodes.node(dofs[i]);
              const auto axes           = directions(nodes.position(node));
              const Tensor<1, 3> inside = fe.unit_support_point(i) - unit_vertices[0];
              FaceNode face_node{node,
                                 Point<2>(inside * (unit_vertices[1] - unit_vertices[0]),
                                          inside * (unit_vertices[2] - unit_vertices[0])),
                                 {in_plane(nodes.position(node)), {}}};
              for (unsigned int c = 0; c < 3; ++c)
                for (unsigned int d = 0; d < 3; ++d)
                  face_node.node.displacement[c].emplace_back(
                      nodes.dof(node, d), axes[c] * nodes.direction(nodes.dof(node, d)));
              found.push_back(face_node);
            }
          builder.add_face(vertices, found);
        }
    return builder.surface;
  }

  ContactSurface shell_surface(const SectorElements &sector, const types::material_id cells)
  {
    const FiniteElement<2, 3> &fe = sector.shell_dofs().get_fe();
    const SectorNodes &nodes      = sector.nodes();
    SurfaceBuilder builder(fe.degree);
    for (const auto &cell : sector.shell_dofs().active_cell_iterators())
      if (cell->material_id() == cells)
      {
        const double height = sector.sector_mesh().sections.at(cells).lower_face();
        const std::vector<SectorNodes::Dof> dofs = sector.dofs_of(cell);
        std::vector<FaceNode> found;
        // A scalar shape function belongs to six degrees of freedom.
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (fe.system_to_component_index(i).first == 0)
          {
            const unsigned int shape = fe.system_to_component_index(i).second;
            const unsigned int node  = nodes.node(dofs[i]);
            const unsigned int turn  = nodes.node(dofs[fe.component_to_system_index(3, shape)]);
            const auto axes          = directions(nodes.position(node));
            FaceNode face_node{
                node, fe.unit_support_point(i), {in_plane(nodes.position(node)), {}}};
            // The face moves by u + theta x (height z): the shell is level where it can touch.
            const Tensor<1, 3> arm = height * axes[0];
            for (unsigned int c = 0; c < 3; ++c)
              for (unsigned int d = 0; d < 3; ++d)
              {
                const SectorNodes::Dof moves = nodes.dof(node, d), turns = nodes.dof(turn, d);
                face_node.node.displacement[c].emplace_back(moves,
                                                            axes[c] * nodes.direction(moves));
                face_node.node.displacement[c].emplace_back(
                    turns, axes[c] * cross_product_3d(nodes.direction(turns), arm));
              }
            found.push_back(face_node);
          }
        std::array<Point<2>, 4> vertices;
        for (unsigned int v = 0; v < 4; ++v)
          vertices[v] = in_plane(cell->vertex(v));
        builder.add_face(vertices, found);
      }
    return builder.surface;
  }

  SectorSurface whole_surface(const ContactSurface &meshed, const SectorForm form)
  {
    SectorSurface whole;
    whole.surface = meshed;
    for (unsigned int i = 0; i < meshed.nodes.size(); ++i)
    {
      whole.surface.nodes[i].displacement = {};
      whole.origin.push_back({i, false});
    }
    if (form == SectorForm::whole)
      return whole;

    std::vector<unsigned int> image(meshed.nodes.size());
    for (unsigned int i = 0; i < meshed.nodes.size(); ++i)
    {
      const Point<2> &place = meshed.nodes[i].place;
      image[i]              = i;
      if (place[1] < 1e-10)
        continue;
      image[i] = whole.surface.nodes.size();
      whole.surface.nodes.push_back({mirrored(place), {}});
      whole.origin.push_back({i, true});
    }
    for (unsigned int face = 0; face < meshed.faces.size(); ++face)
    {
      // Mirrored and reoriented: the local axes are swapped.
      const auto &corners = meshed.corners[face];
      whole.surface.corners.push_back({{mirrored(corners[0]), mirrored(corners[2]),
                                        mirrored(corners[1]), mirrored(corners[3])}});
      const FE_Q<2> element(meshed.degree);
      std::vector<unsigned int> nodes(meshed.faces[face].size());
      for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        const Point<2> unit = element.unit_support_point(i);
        for (unsigned int j = 0; j < nodes.size(); ++j)
          if (element.unit_support_point(j).distance(Point<2>(unit[1], unit[0])) < 1e-10)
            nodes[j] = image[meshed.faces[face][i]];
      }
      whole.surface.faces.push_back(nodes);
    }
    return whole;
  }

  std::vector<LinearForm> displacement_forms(const ContactSurface &surface)
  {
    std::vector<LinearForm> forms;
    for (const SurfaceNode &node : surface.nodes)
      forms.insert(forms.end(), node.displacement.begin(), node.displacement.end());
    return forms;
  }
} // namespace ringmotor
