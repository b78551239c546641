// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/graded_lines.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/interface_grading.h>
#include <ringmotor/mesh/section_layers.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Corners of the boundary at which the angle inside exceeds a straight one. */
    SectionPoints reentrant_corners(const Section &section)
    {
      constexpr double straight = numbers::PI + 0.05;
      std::map<unsigned int, double> angles;
      for (const Section::Cell &cell : section.cells)
        for (unsigned int i = 0; i < 4; ++i)
        {
          const Point<2> &corner = section.points[cell.corners[i]];
          const Tensor<1, 2> a   = section.points[cell.corners[(i + 1) % 4]] - corner,
                             b   = section.points[cell.corners[(i + 3) % 4]] - corner;
          angles[cell.corners[i]] += std::acos(std::clamp(a * b / (a.norm() * b.norm()), -1., 1.));
        }
      SectionPoints corners;
      for (const auto &[edge, cells] : section.cells_at_edges())
        if (cells.size() == 1)
          for (const unsigned int end : {edge.first, edge.second})
            if (angles.at(end) > straight)
              corners.insert(end);
      return corners;
    }
  } // namespace

  SectionPoints singular_points(const Section &section)
  {
    SectionPoints points = reentrant_corners(section);
    Section slot         = section;
    slot.cells.erase(std::remove_if(slot.cells.begin(), slot.cells.end(),
                                    [](const Section::Cell &cell)
                                    { return cell.part == ids::tooth; }),
                     slot.cells.end());
    points.merge(reentrant_corners(slot));
    std::map<unsigned int, unsigned int> n_clamped; // edges
    for (const auto &[edge, name] : section.names)
      if (name == ids::clamped)
        for (const unsigned int end : {edge.first, edge.second})
          ++n_clamped[end];
    for (const auto &[point, n_edges] : n_clamped)
      if (n_edges == 1)
        points.insert(point);
    return points;
  }

  SectionGrading::SectionGrading(const Section &section)
      : section(section), cuts(section), families(cuts.n_families())
  {
  }

  void SectionGrading::want(const unsigned int from, const unsigned int to, const Wanted &lines)
  {
    const Section::Edge edge      = Section::edge(from, to);
    Family &family                = families[cuts.family(edge)];
    const bool at_begin           = cuts.is_along(edge) == (from < to);
    std::optional<Wanted> &wanted = at_begin ? family.at_begin : family.at_end;
    if (!wanted || lines.share < wanted->share)
      wanted = lines;
  }

  void SectionGrading::grow(const unsigned int from, const unsigned int to, const double share,
                            const Growth &growth)
  {
    const auto lines = [&](const double part)
    { return graded_lines(part, share, growth.ratio, growth.longest); };
    want(from, to, {share, lines(1.), lines(0.5)});
  }

  void SectionGrading::shrink(const unsigned int from, const unsigned int to,
                              const unsigned int n_cells, const double ratio)
  {
    const auto lines = [&](const double part) { return lines_from_edge(part, n_cells, ratio); };
    want(from, to, {lines(1.).at(1), lines(1.), lines(0.5)});
  }

  void SectionGrading::grow_from(const SectionPoints &points, const double share,
                                 const Growth &growth, const std::optional<double> &thinnest)
  {
    std::map<unsigned int, double> shortest;
    const auto edges         = section.cells_at_edges();
    const auto for_each_edge = [&](const auto &visit)
    {
      for (const auto &[edge, cells] : edges)
        for (const auto &[from, to] : {edge, Section::Edge{edge.second, edge.first}})
          if (points.count(from) > 0)
            visit(from, to, section.length(edge));
    };
    for_each_edge(
        [&](const unsigned int from, const unsigned int, const double length)
        {
          double &known = shortest.emplace(from, length).first->second;
          known         = std::min(known, length);
        });
    for_each_edge(
        [&](const unsigned int from, const unsigned int to, const double length)
        { grow(from, to, share * thinnest.value_or(shortest.at(from)) / length, growth); });
  }

  void SectionGrading::cut(const unsigned int from, const unsigned int to,
                           const std::vector<double> &at)
  {
    cuts.cut(from, to, at);
    families[cuts.family(Section::edge(from, to))].is_cut = true;
  }

  Section SectionGrading::result() const
  {
    SectionCuts all = cuts;
    for (const auto &[edge, cells] : section.cells_at_edges())
    {
      const Family &family = families[cuts.family(edge)];
      if (family.is_cut)
        continue;
      const bool is_along     = cuts.is_along(edge);
      const auto [begin, end] = is_along ? edge : Section::Edge{edge.second, edge.first};
      const bool meet         = family.at_begin && family.at_end;
      const auto cut =
          [&](const unsigned int from, const unsigned int to, const std::optional<Wanted> &wanted)
      {
        if (wanted)
          all.cut(from, to, meet ? wanted->half : wanted->whole);
      };
      cut(begin, end, family.at_begin);
      cut(end, begin, family.at_end);
    }
    return all.result();
  }

  Section with_layers(const Section &section, const SectionPoints &points,
                      const unsigned int n_layers, const double ratio)
  {
    if (n_layers == 0)
      return section;
    Section layered{section.points, {}, {}, section.shell};
    std::map<std::tuple<unsigned int, unsigned int, unsigned int>, unsigned int> on_edges;
    /** On the edge from one of the points to another point, after so many layers. */
    const auto on_edge =
        [&](const unsigned int point, const unsigned int to, const unsigned int layer)
    {
      if (layer == 0)
        return to;
      const auto [entry, is_new] =
          on_edges.emplace(std::make_tuple(point, to, layer), layered.points.size());
      if (is_new)
        layered.points.push_back(section.points[point] +
                                 std::pow(ratio, layer) *
                                     (section.points[to] - section.points[point]));
      return entry->second;
    };
    for (const Section::Cell &cell : section.cells)
    {
      const std::array<unsigned int, 4> &c = cell.corners;
      unsigned int i                       = 0;
      while (i < 4 && points.count(c[i]) == 0)
        ++i;
      if (i == 4)
      {
        layered.cells.push_back(cell);
        continue;
      }
      const unsigned int at = c[i], next = c[(i + 1) % 4], far = c[(i + 2) % 4],
                         last = c[(i + 3) % 4];
      Assert(points.count(next) + points.count(far) + points.count(last) == 0,
             ExcMessage("a cell has two singular points"));
      unsigned int outer = far;
      for (unsigned int layer = 0; layer < n_layers; ++layer)
      {
        // The place of the cell's map, which is bilinear, at equal coordinates.
        const double x           = std::pow(ratio, layer + 1);
        const unsigned int inner = layered.points.size();
        layered.points.push_back(Point<2>(
            (1. - x) * (1. - x) * section.points[at] + x * (1. - x) * section.points[next] +
            x * x * section.points[far] + x * (1. - x) * section.points[last]));
        layered.cells.push_back(
            {{{on_edge(at, next, layer + 1), on_edge(at, next, layer), outer, inner}}, cell.part});
        layered.cells.push_back(
            {{{inner, outer, on_edge(at, last, layer), on_edge(at, last, layer + 1)}}, cell.part});
        outer = inner;
      }
      layered.cells.push_back(
          {{{at, on_edge(at, next, n_layers), outer, on_edge(at, last, n_layers)}}, cell.part});
    }
    for (const auto &[edge, name] : section.names)
    {
      const bool from_first = points.count(edge.first) > 0;
      if (!from_first && points.count(edge.second) == 0)
      {
        layered.names[edge] = name;
        continue;
      }
      const auto [at, to] = from_first ? edge : Section::Edge{edge.second, edge.first};
      unsigned int outer  = to;
      for (unsigned int layer = 1; layer <= n_layers; ++layer)
      {
        const unsigned int inner                   = on_edge(at, to, layer);
        layered.names[Section::edge(inner, outer)] = name;
        outer                                      = inner;
      }
      layered.names[Section::edge(at, outer)] = name;
    }
    return layered;
  }
} // namespace ringmotor
