// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/graded_lines.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/interface_grading.h>
#include <ringmotor/mesh/section_layers.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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
    std::vector<bool> is_done(families.size());
    for (const auto &[edge, cells] : section.cells_at_edges())
    {
      const unsigned int number = cuts.family(edge);
      const Family &family      = families[number];
      if (family.is_cut || is_done[number])
        continue;
      is_done[number]         = true;
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

  namespace
  {
    /** Puts layers of cells around points into a section. */
    class Layering
    {
    public:
      Layering(const Section &section, const SectionPoints &points, const unsigned int n_layers,
               const double ratio)
          : section(section), points(points), n_layers(n_layers),
            ratio(ratio), layered{section.points, {}, {}, section.shell}
      {
        for (const Section::Cell &cell : section.cells)
          add_cell(cell);
        for (const auto &[edge, name] : section.names)
          add_name(edge, name);
      }

      Section result() const { return layered; }

    private:
      /** On the edge from one of the points to another point, after so many layers. */
      unsigned int on_edge(const unsigned int point, const unsigned int to,
                           const unsigned int layer)
      {
        if (layer == 0)
          return to;
        const auto [entry, is_new] = on_edges.emplace(
            std::array<unsigned int, 3>{{point, to, layer}}, layered.points.size());
        if (is_new)
          layered.points.push_back(section.points[point] +
                                   std::pow(ratio, layer) *
                                       (section.points[to] - section.points[point]));
        return entry->second;
      }

      void add_cell(const Section::Cell &cell)
      {
        const auto at =
            std::find_if(cell.corners.begin(), cell.corners.end(),
                         [&](const unsigned int corner) { return points.count(corner) > 0; });
        if (at == cell.corners.end())
          layered.cells.push_back(cell);
        else
          add_layers(cell, at - cell.corners.begin());
      }

      void add_layers(const Section::Cell &cell, const unsigned int first)
      {
        const auto corner     = [&](const unsigned int i) { return cell.corners[(first + i) % 4]; };
        const unsigned int at = corner(0), next = corner(1), far = corner(2), last = corner(3);
        Assert(points.count(next) + points.count(far) + points.count(last) == 0,
               ExcMessage("a cell has two singular points"));
        unsigned int outer = far;
        for (unsigned int layer = 0; layer < n_layers; ++layer)
        {
          const unsigned int inner = on_diagonal(at, next, far, last, layer + 1);
          layered.cells.push_back(
              {{{on_edge(at, next, layer + 1), on_edge(at, next, layer), outer, inner}},
               cell.part});
          layered.cells.push_back(
              {{{inner, outer, on_edge(at, last, layer), on_edge(at, last, layer + 1)}},
               cell.part});
          outer = inner;
        }
        layered.cells.push_back(
            {{{at, on_edge(at, next, n_layers), outer, on_edge(at, last, n_layers)}}, cell.part});
      }

      /** A new point where both coordinates of the cell's bilinear map are the same. */
      unsigned int on_diagonal(const unsigned int at, const unsigned int next,
                               const unsigned int far, const unsigned int last,
                               const unsigned int layer)
      {
        const std::vector<Point<2>> &x = section.points;
        const double share             = std::pow(ratio, layer);
        const Tensor<1, 2> low         = x[at] + share * (x[next] - x[at]),
                           high        = x[last] + share * (x[far] - x[last]);
        layered.points.emplace_back(low + share * (high - low));
        return layered.points.size() - 1;
      }

      void add_name(const Section::Edge &edge, const types::boundary_id name)
      {
        const bool from_first = points.count(edge.first) > 0;
        const auto [at, to]   = from_first ? edge : Section::Edge{edge.second, edge.first};
        const bool has_layers = points.count(at) > 0;
        unsigned int outer    = to;
        for (unsigned int layer = 1; has_layers && layer <= n_layers; ++layer)
        {
          const unsigned int inner                   = on_edge(at, to, layer);
          layered.names[Section::edge(inner, outer)] = name;
          outer                                      = inner;
        }
        layered.names[Section::edge(at, outer)] = name;
      }

      const Section &section;
      const SectionPoints &points;
      const unsigned int n_layers;
      const double ratio;
      Section layered;
      std::map<std::array<unsigned int, 3>, unsigned int> on_edges; ///< point, to, layer
    };
  } // namespace

  Section with_layers(const Section &section, const SectionPoints &points,
                      const unsigned int n_layers, const double ratio)
  {
    return n_layers == 0 ? section : Layering(section, points, n_layers, ratio).result();
  }
} // namespace ringmotor
