// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/merged_section.h>
#include <ringmotor/mesh/places.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Finds a line of edges between cells, from one outer point to another. */
    class DividingLine
    {
    public:
      explicit DividingLine(const Section &section)
          : section(section), at_edges(section.cells_at_edges())
      {
        for (const auto &[edge, cells] : at_edges)
          for (const unsigned int end : {edge.first, edge.second})
            edges_at[end].push_back(edge);
      }

      /** The edges of the line from an outer point, if it only divides cells. */
      std::optional<std::vector<Section::Edge>> from(const unsigned int begin) const
      {
        if (!crosses_straight_outline(begin))
          return {};
        std::vector<Section::Edge> line;
        for (unsigned int at = begin; line.empty() || !is_outer(at);)
        {
          const std::optional<Section::Edge> next = next_edge(at, line);
          if (!next || !divides_one_part(*next))
            return {};
          line.push_back(*next);
          at = next->first == at ? next->second : next->first;
          if (!(is_outer(at) ? crosses_straight_outline(at) : is_straight_inside(at, *next)))
            return {};
        }
        return line;
      }

    private:
      bool is_outer(const Section::Edge &edge) const { return at_edges.at(edge).size() == 1; }

      bool is_outer(const unsigned int point) const
      {
        const auto &edges = edges_at.at(point);
        return std::any_of(edges.begin(), edges.end(),
                           [&](const Section::Edge &edge) { return is_outer(edge); });
      }

      static unsigned int other_end(const Section::Edge &edge, const unsigned int point)
      {
        return edge.first == point ? edge.second : edge.first;
      }

      /** Whether two edges at a point continue each other. */
      bool are_straight(const unsigned int point, const Section::Edge &one,
                        const Section::Edge &other) const
      {
        const Tensor<1, 2> a = section.points[other_end(one, point)] - section.points[point],
                           b = section.points[other_end(other, point)] - section.points[point];
        return a * b < 0. && std::abs(a[0] * b[1] - a[1] * b[0]) < places::file_rounding *
                                                                       section.points[point][0] *
                                                                       std::max(a.norm(), b.norm());
      }

      types::boundary_id name_of(const Section::Edge &edge) const
      {
        const auto found = section.names.find(edge);
        return found == section.names.end() ? 0 : found->second;
      }

      /** An outer point with two cells between edges that continue each other under one name. */
      bool crosses_straight_outline(const unsigned int point) const
      {
        std::vector<Section::Edge> outer;
        for (const Section::Edge &edge : edges_at.at(point))
          if (is_outer(edge))
            outer.push_back(edge);
        return outer.size() == 2 && edges_at.at(point).size() == 3 &&
               name_of(outer[0]) == name_of(outer[1]) && are_straight(point, outer[0], outer[1]);
      }

      bool divides_one_part(const Section::Edge &edge) const
      {
        const std::vector<unsigned int> &cells = at_edges.at(edge);
        return section.cells[cells[0]].part == section.cells[cells[1]].part;
      }

      bool share_a_cell(const Section::Edge &one, const Section::Edge &other) const
      {
        const auto &a = at_edges.at(one), &b = at_edges.at(other);
        return std::any_of(a.begin(), a.end(),
                           [&](const unsigned int cell)
                           { return std::find(b.begin(), b.end(), cell) != b.end(); });
      }

      /** The edge inside the section that leads on. */
      std::optional<Section::Edge> next_edge(const unsigned int at,
                                             const std::vector<Section::Edge> &line) const
      {
        for (const Section::Edge &edge : edges_at.at(at))
          if (!is_outer(edge) &&
              (line.empty() || (edge != line.back() && !share_a_cell(edge, line.back()))))
            return edge;
        return {};
      }

      /** A point where the line crosses edges that continue each other. */
      bool is_straight_inside(const unsigned int point, const Section::Edge &along) const
      {
        std::vector<Section::Edge> across;
        for (const Section::Edge &edge : edges_at.at(point))
          if (edge != along && share_a_cell(edge, along))
            across.push_back(edge);
        return edges_at.at(point).size() == 4 && across.size() == 2 &&
               are_straight(point, across[0], across[1]);
      }

      const Section &section;
      const std::map<Section::Edge, std::vector<unsigned int>> at_edges;
      std::map<unsigned int, std::vector<Section::Edge>> edges_at; ///< by point
    };

    /** The cell of two that share an edge. */
    Section::Cell merged(const Section::Cell &one, const Section::Cell &other,
                         const Section::Edge &shared)
    {
      const auto first = [&](const Section::Cell &cell)
      {
        unsigned int i = 0;
        while (Section::edge(cell, i) != shared)
          ++i;
        return i;
      };
      const auto corner = [](const Section::Cell &cell, const unsigned int i)
      { return cell.corners[i % 4]; };
      const unsigned int i = first(one), j = first(other);
      return {
          {{corner(other, j + 2), corner(other, j + 3), corner(one, i + 2), corner(one, i + 3)}},
          one.part};
    }

    Section without(const std::vector<Section::Edge> &line, const Section &section)
    {
      const auto at_edges = section.cells_at_edges();
      Section result{section.points, {}, {}, section.shell};
      std::set<unsigned int> gone, removed; // cells, points
      for (const Section::Edge &edge : line)
      {
        const std::vector<unsigned int> &pair = at_edges.at(edge);
        result.cells.push_back(merged(section.cells[pair[0]], section.cells[pair[1]], edge));
        gone.insert(pair.begin(), pair.end());
        removed.insert({edge.first, edge.second});
      }
      for (unsigned int cell = 0; cell < section.cells.size(); ++cell)
        if (gone.count(cell) == 0)
          result.cells.push_back(section.cells[cell]);
      std::map<unsigned int, std::vector<unsigned int>> ends; // of edges joined at a removed point
      std::map<unsigned int, types::boundary_id> names;
      for (const auto &[edge, name] : section.names)
        for (const auto &[point, other] : {edge, Section::Edge{edge.second, edge.first}})
          if (removed.count(point) > 0)
          {
            ends[point].push_back(other);
            names[point] = name;
          }
      for (const auto &[point, others] : ends)
        result.names[Section::edge(others.at(0), others.at(1))] = names.at(point);
      for (const auto &[edge, name] : section.names)
        if (removed.count(edge.first) + removed.count(edge.second) == 0)
          result.names[edge] = name;
      return result;
    }
  } // namespace

  Section without_lines_from(const types::boundary_id name, const Section &section)
  {
    std::map<unsigned int, unsigned int> n_edges;
    for (const Section::Edge &edge : section.edges_named(name))
      for (const unsigned int end : {edge.first, edge.second})
        ++n_edges[end];
    for (const auto &[point, number] : n_edges)
      if (number == 2)
        if (const auto line = DividingLine(section).from(point))
          return without_lines_from(name, without(*line, section));
    return section;
  }
} // namespace ringmotor
