// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/revolved.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  std::vector<Section::Edge> feet_of_teeth(const Section &section)
  {
    std::vector<Section::Edge> feet;
    const auto is_tooth = [&](const unsigned int cell)
    { return section.cells[cell].part == ids::tooth; };
    for (const auto &[edge, cells] : section.cells_at_edges())
      if (cells.size() == 2 && is_tooth(cells[0]) != is_tooth(cells[1]))
        feet.push_back(edge);
    return feet;
  }

  Slots slots_of(const Section &section, const unsigned int n_teeth, const double width,
                 const std::optional<double> &angle)
  {
    Slots slots{n_teeth, width, angle};
    for (const Section::Cell &cell : section.cells)
      if (cell.part == ids::tooth)
        for (const unsigned int corner : cell.corners)
        {
          const double radius = section.points[corner][0];
          slots.inner_radius  = slots.has_teeth() ? std::min(slots.inner_radius, radius) : radius;
        }
    return slots;
  }

  RootEdges root_edges(const Section &section)
  {
    const auto at = section.cells_at_edges();
    RootEdges roots;
    roots.of_cells.assign(section.cells.size(), RootEdges::none);
    std::vector<unsigned int> reached;
    const auto mark = [&](const unsigned int cell, const Section::Edge &edge)
    {
      for (unsigned int i = 0; i < 4; ++i)
        if (Section::edge(section.cells[cell], i) == edge)
        {
          unsigned int &known = roots.of_cells[cell];
          roots.cross         = roots.cross || (known != RootEdges::none && known != i);
          if (known == RootEdges::none)
            reached.push_back(cell);
          known = i;
        }
    };
    for (const Section::Edge &foot : feet_of_teeth(section))
      for (const unsigned int cell : at.at(foot))
        mark(cell, foot);
    while (!reached.empty() && !roots.cross)
    {
      const unsigned int cell = reached.back(), i = roots.of_cells[cell];
      reached.pop_back();
      const std::array<unsigned int, 4> &c = section.cells[cell].corners;
      for (const unsigned int other : at.at(Section::edge(section.cells[cell], i)))
        mark(other, Section::edge(section.cells[cell], i));
      // Across the edges at both ends, to those that begin at the same end.
      for (const unsigned int side : {(i + 1) % 4, (i + 3) % 4})
      {
        const unsigned int end = side == (i + 1) % 4 ? c[(i + 1) % 4] : c[i];
        for (const unsigned int other : at.at(Section::edge(section.cells[cell], side)))
          if (other != cell)
            for (unsigned int j = 0; j < 4; ++j)
              if (const auto edge = Section::edge(section.cells[other], j);
                  edge != Section::edge(section.cells[cell], side) &&
                  (edge.first == end || edge.second == end))
                mark(other, edge);
      }
    }
    return roots;
  }

  namespace
  {
    using Quad = std::array<unsigned int, 4>;

    Quad sorted(Quad vertices)
    {
      std::sort(vertices.begin(), vertices.end());
      return vertices;
    }

    /** Makes cells of a sector from those of its section between lines along theta. */
    class Revolver
    {
    public:
      Revolver(const Section &section, const Slots &slots, const Revolution &revolution);

      void create(Triangulation<3> &triangulation);

    private:
      /** A point of the section at a place along theta. */
      using Vertex = std::pair<unsigned int, double>;
      /** Layers away from a root along the section, and from the side of the tooth along theta; 0:
       * as far as the cell goes. */
      struct Distance
      {
        unsigned int depth, along;
      };
      static constexpr unsigned int at_root = numbers::invalid_unsigned_int;

      void add_half(const double sign);
      /** Adds the cells between lines from @p side of the tooth to @p far. */
      void add_at_root(const unsigned int number, const double side, const double far);
      unsigned int point_between(const unsigned int root, const unsigned int opposite,
                                 const unsigned int layer);
      unsigned int number_of(const Vertex &vertex);
      void add_cell(const std::array<Vertex, 8> &corners, const types::material_id part);
      void add_name(const Section::Edge &edge, const std::array<Vertex, 4> &face);
      types::boundary_id id_of(const Triangulation<3>::face_iterator &face) const;
      void mark(Triangulation<3> &triangulation) const;

      const Section &section;
      const Slots &slots;
      const Revolution &revolution;
      std::map<Section::Edge, types::boundary_id> edge_names;
      std::vector<unsigned int> roots; ///< see RootEdges; empty without layers
      std::vector<Point<2>> points;    ///< those of the section, and between them
      std::map<std::array<unsigned int, 3>, unsigned int> between; ///< root, opposite, layer
      std::map<Vertex, unsigned int> numbers_of_vertices;
      std::vector<Vertex> vertices;
      std::vector<CellData<3>> cells;
      std::map<Quad, types::boundary_id> names; ///< of faces, by ascending vertices
    };

    Revolver::Revolver(const Section &section, const Slots &slots, const Revolution &revolution)
        : section(section), slots(slots), revolution(revolution), edge_names(section.names),
          points(section.points)
    {
      if (revolution.parts == SectorParts::tooth)
        for (const Section::Edge &foot : feet_of_teeth(section))
          edge_names[foot] = ids::tooth_foot;
      if (const RootEdges found = root_edges(section); revolution.n_layers > 0 && !found.cross)
        roots = found.of_cells;
      for (const double sign : {1., -1.})
        if (sign > 0. || revolution.form == SectorForm::whole)
          add_half(sign);
    }

    unsigned int Revolver::number_of(const Vertex &vertex)
    {
      const auto [entry, is_new] = numbers_of_vertices.emplace(vertex, vertices.size());
      if (is_new)
        vertices.push_back(vertex);
      return entry->second;
    }

    unsigned int Revolver::point_between(const unsigned int root, const unsigned int opposite,
                                         const unsigned int layer)
    {
      if (layer == 0)
        return opposite;
      const auto [entry, is_new] =
          between.emplace(std::array<unsigned int, 3>{{root, opposite, layer}}, points.size());
      if (is_new)
        points.push_back(section.points[root] +
                         std::pow(revolution.ratio, layer) *
                             (section.points[opposite] - section.points[root]));
      return entry->second;
    }

    void Revolver::add_cell(const std::array<Vertex, 8> &corners, const types::material_id part)
    {
      cells.emplace_back();
      cells.back().material_id = part;
      for (unsigned int i = 0; i < 8; ++i)
        cells.back().vertices[i] = number_of(corners[i]);
    }

    void Revolver::add_name(const Section::Edge &edge, const std::array<Vertex, 4> &face)
    {
      const auto name = edge_names.find(edge);
      if (name == edge_names.end())
        return;
      Quad quad;
      for (unsigned int i = 0; i < 4; ++i)
        quad[i] = number_of(face[i]);
      names[sorted(quad)] = name->second;
    }

    void Revolver::add_half(const double sign)
    {
      for (unsigned int line = 0; line + 1 < revolution.lines.size(); ++line)
      {
        const double near = revolution.lines[line], far = revolution.lines[line + 1],
                     from = sign * near, to = sign * far;
        const bool in_slot = slots.has_teeth() && near >= 1.;
        for (unsigned int number = 0; number < section.cells.size(); ++number)
        {
          const Section::Cell &cell = section.cells[number];
          const Quad &c             = cell.corners;
          const bool is_missing     = revolution.parts == SectorParts::tooth
                                          ? in_slot || cell.part != ids::tooth
                                          : in_slot && cell.part == ids::tooth;
          if (is_missing)
            continue;
          if (!roots.empty() && roots[number] != RootEdges::none && (near == 1. || far == 1.))
          {
            add_at_root(number, sign, near == 1. ? to : from);
            continue;
          }
          for (unsigned int i = 0; i < 4; ++i)
            add_name(Section::edge(cell, i),
                     {{{c[i], from}, {c[(i + 1) % 4], from}, {c[i], to}, {c[(i + 1) % 4], to}}});
          add_cell({{{c[0], from},
                     {c[1], from},
                     {c[3], from},
                     {c[2], from},
                     {c[0], to},
                     {c[1], to},
                     {c[3], to},
                     {c[2], to}}},
                   cell.part);
        }
      }
    }

    void Revolver::add_at_root(const unsigned int number, const double side, const double far)
    {
      const Section::Cell &cell = section.cells[number];
      const unsigned int first = roots[number], n = revolution.n_layers;
      const auto corner_of = [&](const unsigned int i) { return cell.corners[(first + i) % 4]; };
      // The ends of the root's edge, and the corners opposite to them.
      const std::array<unsigned int, 2> root{{corner_of(0), corner_of(1)}},
          opposite{{corner_of(3), corner_of(2)}};
      const auto vertex = [&](const unsigned int end, const Distance &at) -> Vertex
      {
        return {at.depth == at_root ? root[end] : point_between(root[end], opposite[end], at.depth),
                at.along == at_root ? side
                : at.along == 0     ? far
                                    : side + std::pow(revolution.ratio, at.along) * (far - side)};
      };
      const auto add_prism = [&](const std::array<Distance, 4> &around)
      {
        std::array<std::array<Vertex, 4>, 2> ends;
        for (const unsigned int end : {0u, 1u})
        {
          for (unsigned int i = 0; i < 4; ++i)
            ends[end][i] = vertex(end, around[i]);
          add_name(Section::edge(root[end], opposite[end]), ends[end]);
        }
        const auto &[a, b] = ends;
        for (unsigned int i = 0; i < 4; ++i)
        {
          const unsigned int next = (i + 1) % 4;
          const auto lies_at      = [&](const unsigned int depth)
          { return around[i].depth == depth && around[next].depth == depth; };
          for (const auto &[depth, points] : {std::make_pair(at_root, root), {0u, opposite}})
            if (lies_at(depth))
              add_name(Section::edge(points[0], points[1]), {{a[i], a[next], b[i], b[next]}});
        }
        add_cell({{a[0], a[1], a[3], a[2], b[0], b[1], b[3], b[2]}}, cell.part);
      };
      for (unsigned int outer = 0; outer < n; ++outer)
      {
        const unsigned int inner = outer + 1;
        add_prism({{{at_root, inner}, {at_root, outer}, {outer, outer}, {inner, inner}}});
        add_prism({{{inner, at_root}, {inner, inner}, {outer, outer}, {outer, at_root}}});
      }
      add_prism({{{at_root, at_root}, {at_root, n}, {n, n}, {n, at_root}}});
    }

    void Revolver::create(Triangulation<3> &triangulation)
    {
      std::vector<Point<3>> places;
      for (const auto &[point, place] : vertices)
      {
        const double radius = points[point][0];
        places.push_back(
            cartesian(Point<3>(radius, slots.angle_at(place, radius), points[point][1])));
      }
      GridTools::invert_cells_with_negative_measure(places, cells);
      GridTools::consistently_order_cells(cells);
      triangulation.create_triangulation(places, cells, SubCellData());
      mark(triangulation);
      triangulation.set_all_manifold_ids(0);
      triangulation.set_manifold(0, RevolvedManifold<3>(slots));
    }

    types::boundary_id Revolver::id_of(const Triangulation<3>::face_iterator &face) const
    {
      const bool is_half  = revolution.form == SectorForm::half,
                 has_cuts = revolution.parts == SectorParts::all;
      const double last   = revolution.lines.back();
      const auto lies_at  = [&](const double place)
      {
        for (unsigned int i = 0; i < 4; ++i)
          if (vertices[face->vertex_index(i)].second != place)
            return false;
        return true;
      };
      if (has_cuts && lies_at(last))
        return is_half ? ids::cut : ids::cut_high;
      if (lies_at(is_half ? 0. : -last))
        return is_half ? ids::mirror : ids::cut_low;
      Quad quad;
      for (unsigned int i = 0; i < 4; ++i)
        quad[i] = face->vertex_index(i);
      const auto name = names.find(sorted(quad));
      return name == names.end() ? ids::free : name->second;
    }

    void Revolver::mark(Triangulation<3> &triangulation) const
    {
      double outermost = 0.;
      for (const Section::Edge &top : section.edges_named(ids::tooth_top))
        for (const unsigned int end : {top.first, top.second})
          outermost = std::max(outermost, points[end][0]);
      const auto is_outermost = [&](const unsigned int vertex)
      { return is_same_place(points[vertices[vertex].first][0], outermost, outermost); };
      for (const auto &face : triangulation.active_face_iterators())
        if (face->at_boundary())
        {
          face->set_boundary_id(id_of(face));
          for (unsigned int i = 0; i < 4; ++i)
            if (const auto line = face->line(i); face->boundary_id() == ids::tooth_top &&
                                                 is_outermost(line->vertex_index(0)) &&
                                                 is_outermost(line->vertex_index(1)))
              line->set_boundary_id(ids::target_plate);
        }
    }
  } // namespace

  SectorMesh revolve(const Section &section, const Slots &slots, const Revolution &revolution,
                     MPI_Comm communicator)
  {
    SectorMesh mesh;
    mesh.triangulation = empty_triangulation<3>(communicator);
    mesh.form          = revolution.form;
    mesh.n_sectors     = slots.n_sectors;
    mesh.has_cuts      = revolution.parts == SectorParts::all;
    Revolver(section, slots, revolution).create(*mesh.triangulation);
    return mesh;
  }
} // namespace ringmotor
