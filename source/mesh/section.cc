// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/section.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace ringmotor
{
  using namespace dealii;

  std::map<Section::Edge, std::vector<unsigned int>> Section::cells_at_edges() const
  {
    std::map<Edge, std::vector<unsigned int>> at;
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      for (unsigned int i = 0; i < 4; ++i)
        at[edge(cells[cell], i)].push_back(cell);
    return at;
  }

  bool Section::has_part(const types::material_id part) const
  {
    return std::any_of(cells.begin(), cells.end(),
                       [&](const Cell &cell) { return cell.part == part; });
  }

  bool Section::is_named(const Edge &edge, const types::boundary_id name) const
  {
    const auto found = names.find(edge);
    return found != names.end() && found->second == name;
  }

  std::vector<Section::Edge> Section::edges_named(const types::boundary_id name) const
  {
    std::vector<Edge> edges;
    for (const auto &[edge, name_of_edge] : names)
      if (name_of_edge == name)
        edges.push_back(edge);
    return edges;
  }

  Point<2> Section::middle(const Cell &cell) const
  {
    Point<2> sum;
    for (const unsigned int corner : cell.corners)
      sum += 0.25 * points[corner];
    return sum;
  }

  std::vector<Section::Across> Section::edges_across(const types::boundary_id name) const
  {
    std::vector<Across> edges;
    for (const Cell &cell : cells)
      for (unsigned int i = 0; i < 4; ++i)
        if (is_named(edge(cell, i), name))
        {
          edges.push_back({cell.corners[i], cell.corners[(i + 3) % 4]});
          edges.push_back({cell.corners[(i + 1) % 4], cell.corners[(i + 2) % 4]});
        }
    return edges;
  }

  Section Section::only(const types::material_id part) const
  {
    Section kept{points, {}, {}, shell};
    std::set<Edge> edges;
    for (const Cell &cell : cells)
      if (cell.part == part)
      {
        kept.cells.push_back(cell);
        for (unsigned int i = 0; i < 4; ++i)
          edges.insert(edge(cell, i));
      }
    for (const auto &[edge, name] : names)
      if (edges.count(edge) > 0)
        kept.names[edge] = name;
    return kept;
  }

  std::string name_of_part(const types::material_id part)
  {
    static const std::map<types::material_id, std::string> names{
        {ids::base, "base"},   {ids::tooth, "tooth"},   {ids::piezoceramic, "piezoceramic"},
        {ids::rotor, "rotor"}, {ids::lining, "lining"}, {ids::adhesive, "adhesive"}};
    const auto found = names.find(part);
    return found == names.end() ? "" : found->second;
  }

  std::string name_of_edge(const types::boundary_id edge)
  {
    static const std::map<types::boundary_id, std::string> names{
        {ids::tooth_top, "contact"}, {ids::lip, "contact"},     {ids::ring_top, "pressed"},
        {ids::ring_bore, "driven"},  {ids::clamped, "clamped"}, {ids::radial_bars, "bars"},
        {ids::bottom, "felt"}};
    const auto found = names.find(edge);
    return found == names.end() ? "" : found->second;
  }

  SectionCuts::SectionCuts(const Section &section) : section(section)
  {
    const auto at = section.cells_at_edges();
    for (const auto &[first, cells_at_first] : at)
    {
      if (place.count(first) > 0)
        continue;
      place[first] = {n_families(), true};
      std::vector<Section::Edge> reached{first};
      while (!reached.empty())
      {
        const Section::Edge edge = reached.back();
        reached.pop_back();
        for (const unsigned int number : at.at(edge))
        {
          const std::array<unsigned int, 4> &c = section.cells[number].corners;
          for (unsigned int i = 0; i < 4; ++i)
            if (Section::edge(section.cells[number], i) == edge)
            {
              // c[i] faces c[i + 3], c[i + 1] faces c[i + 2].
              const unsigned int from = c[(i + 3) % 4], to = c[(i + 2) % 4];
              const bool is_along = place.at(edge).is_along == (c[i] < c[(i + 1) % 4]);
              if (place
                      .emplace(Section::edge(from, to),
                               Place{n_families(), is_along == (from < to)})
                      .second)
                reached.push_back(Section::edge(from, to));
            }
        }
      }
      fractions.emplace_back();
    }
  }

  void SectionCuts::cut(const unsigned int from, const unsigned int to,
                        const std::vector<double> &at)
  {
    const auto &[family, is_along] = place.at(Section::edge(from, to));
    std::vector<double> &all       = fractions[family];
    for (const double fraction : at)
      all.push_back(is_along == (from < to) ? fraction : 1. - fraction);
    std::sort(all.begin(), all.end());
    const auto is_same = [](const double a, const double b) { return is_same_place(a, b, 1.); };
    all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](const double a) { return is_same(a, 0.) || is_same(a, 1.); }),
              all.end());
  }

  std::vector<double> SectionCuts::cuts_of(const unsigned int from, const unsigned int to) const
  {
    const auto &[family, is_along] = place.at(Section::edge(from, to));
    std::vector<double> at         = fractions[family];
    if (is_along != (from < to))
    {
      std::reverse(at.begin(), at.end());
      for (double &fraction : at)
        fraction = 1. - fraction;
    }
    return at;
  }

  Section SectionCuts::result() const
  {
    Section cut{section.points, {}, {}, section.shell};
    // Points on edges, by the edge and their number from its first end.
    std::map<std::tuple<unsigned int, unsigned int, unsigned int>, unsigned int> on_edges;
    const auto between = [](const Point<2> &a, const Point<2> &b, const double fraction)
    { return Point<2>(a + fraction * (b - a)); };
    /** All points of an edge, with its ends. */
    const auto points_on = [&](const unsigned int from, const unsigned int to)
    {
      const auto [a, b]               = Section::edge(from, to);
      const std::vector<double> at    = cuts_of(a, b);
      std::vector<unsigned int> along = {a};
      for (unsigned int i = 0; i < at.size(); ++i)
      {
        const auto [entry, is_new] = on_edges.emplace(std::make_tuple(a, b, i), cut.points.size());
        if (is_new)
          cut.points.push_back(between(section.points[a], section.points[b], at[i]));
        along.push_back(entry->second);
      }
      along.push_back(b);
      if (from != a)
        std::reverse(along.begin(), along.end());
      return along;
    };
    for (const Section::Cell &cell : section.cells)
    {
      const std::array<unsigned int, 4> &c = cell.corners;
      const std::vector<unsigned int> low = points_on(c[0], c[1]), high = points_on(c[3], c[2]),
                                      left = points_on(c[0], c[3]), right = points_on(c[1], c[2]);
      const std::vector<double> up = cuts_of(c[0], c[3]);
      std::vector<std::vector<unsigned int>> rows{low};
      for (unsigned int j = 1; j + 1 < left.size(); ++j)
      {
        rows.push_back({left[j]});
        for (unsigned int i = 1; i + 1 < low.size(); ++i)
        {
          rows.back().push_back(cut.points.size());
          cut.points.push_back(between(cut.points[low[i]], cut.points[high[i]], up[j - 1]));
        }
        rows.back().push_back(right[j]);
      }
      rows.push_back(high);
      for (unsigned int j = 0; j + 1 < rows.size(); ++j)
        for (unsigned int i = 0; i + 1 < low.size(); ++i)
          cut.cells.push_back(
              {{{rows[j][i], rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]}}, cell.part});
    }
    for (const auto &[edge, name] : section.names)
    {
      const std::vector<unsigned int> along = points_on(edge.first, edge.second);
      for (unsigned int i = 0; i + 1 < along.size(); ++i)
        cut.names[Section::edge(along[i], along[i + 1])] = name;
    }
    return cut;
  }
} // namespace ringmotor
