// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_section.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/revolved.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  std::string in_words(const Point<2> &place)
  {
    return "r = " + in_millimetres(place[0]) + ", z = " + in_millimetres(place[1]);
  }

  namespace
  {
    double cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    class BodyCheck
    {
    public:
      BodyCheck(const Section &section, const MeshFile &file)
          : section(section), file(file), at_edges(section.cells_at_edges())
      {
        for (const auto &[edge, cells] : at_edges)
          if (cells.size() == 1)
            outer.push_back(edge);
        for (const Point<2> &x : section.points)
          close = std::max(close, places::file_rounding * x[0]);
      }

      void run() const
      {
        check_size();
        check_edges();
        check_pieces();
        check_outline();
        check_gaps();
      }

    private:
      const Point<2> &point(const unsigned int i) const { return section.points[i]; }

      Point<2> middle(const Section::Edge &edge) const
      {
        return Point<2>(0.5 * (point(edge.first) + point(edge.second)));
      }

      void check_size() const
      {
        constexpr double smallest = 1e-4, largest = 1.; // m
        double inner = std::numeric_limits<double>::max(), radius = 0.;
        for (const Point<2> &x : section.points)
        {
          inner  = std::min(inner, x[0]);
          radius = std::max(radius, x[0]);
        }
        if (radius > largest || radius < smallest)
          file.refuse("its outer radius is " + in_metres(radius),
                      "lengths are in m: draw a section in mm with Mesh.ScalingFactor = 0.001");
        if (inner < 0.01 * radius)
          file.refuse("it reaches r = " + in_millimetres(inner),
                      "x is the distance from the axis: leave a bore at the axis, of at least a "
                      "hundredth of the outer radius, and draw one side of the axis only");
      }

      /** At an edge, two cells at most, which run along it in opposite directions. */
      void check_edges() const
      {
        std::set<Section::Edge> directed;
        for (const Section::Cell &cell : section.cells)
          for (unsigned int i = 0; i < 4; ++i)
            if (const Section::Edge along{cell.corners[i], cell.corners[(i + 1) % 4]};
                !directed.insert(along).second)
              file.refuse("cells lie on one another, at " +
                              in_words(middle(Section::edge(along.first, along.second))),
                          "make blocks side by side that share their edges, and each surface part "
                          "of one physical surface only");
      }

      void check_pieces() const
      {
        std::vector<unsigned int> rank(section.cells.size()), parent(section.cells.size());
        boost::disjoint_sets<unsigned int *, unsigned int *> bodies(rank.data(), parent.data());
        for (unsigned int cell = 0; cell < section.cells.size(); ++cell)
          bodies.make_set(cell);
        for (const auto &[edge, cells] : at_edges)
          if (cells.size() == 2)
            bodies.union_set(cells[0], cells[1]);
        for (unsigned int cell = 1; cell < section.cells.size(); ++cell)
          if (bodies.find_set(cell) != bodies.find_set(0u))
            file.refuse("it is in pieces: the cells at " +
                            in_words(section.middle(section.cells.front())) + " and at " +
                            in_words(section.middle(section.cells[cell])) + " are not connected",
                        share_edges);
      }

      /** The outline neither touches nor crosses itself. */
      void check_outline() const
      {
        std::map<unsigned int, unsigned int> n_edges;
        for (const Section::Edge &edge : outer)
          for (const unsigned int end : {edge.first, edge.second})
            if (++n_edges[end] > 2)
              file.refuse("blocks are connected in one point only, at " + in_words(point(end)),
                          share_edges);
        for (const Section::Edge &one : outer)
          for (const Section::Edge &other : outer)
            if (one < other && cross_each_other(one, other))
              file.refuse("blocks lie on one another, at " + in_words(middle(one)),
                          "make blocks side by side that share their edges");
      }

      bool cross_each_other(const Section::Edge &one, const Section::Edge &other) const
      {
        const auto sides = [&](const Section::Edge &edge, const Section::Edge &of)
        {
          const Tensor<1, 2> along = point(edge.second) - point(edge.first);
          return std::make_pair(cross(along, point(of.first) - point(edge.first)) / along.norm(),
                                cross(along, point(of.second) - point(edge.first)) / along.norm());
        };
        const auto are_apart = [&](const std::pair<double, double> &distances)
        {
          return std::min(std::abs(distances.first), std::abs(distances.second)) > close &&
                 (distances.first > 0.) != (distances.second > 0.);
        };
        return are_apart(sides(one, other)) && are_apart(sides(other, one));
      }

      /** No point of the outline lies on an edge or a point of it that is not its own. */
      void check_gaps() const
      {
        std::set<unsigned int> points;
        for (const Section::Edge &edge : outer)
          points.insert({edge.first, edge.second});
        for (const Section::Edge &edge : outer)
          for (const unsigned int i : points)
            if (i != edge.first && i != edge.second && distance(i, edge) < close)
              file.refuse("blocks touch without sharing their points, at " + in_words(point(i)),
                          share_edges + ", with as many cells on both sides");
      }

      double distance(const unsigned int i, const Section::Edge &edge) const
      {
        const Tensor<1, 2> along = point(edge.second) - point(edge.first),
                           to    = point(i) - point(edge.first);
        const double share       = std::clamp(along * to / along.norm_square(), 0., 1.);
        return (to - share * along).norm();
      }

      const std::string share_edges =
          "let blocks share their edges: use the same points and curves (Gmsh: Coherence)";
      const Section &section;
      const MeshFile &file;
      const std::map<Section::Edge, std::vector<unsigned int>> at_edges;
      std::vector<Section::Edge> outer;
      double close = 0.; ///< m
    };
  } // namespace

  bool is_one_line(const std::vector<Section::Edge> &edges)
  {
    std::map<unsigned int, std::vector<unsigned int>> neighbours;
    for (const auto &[a, b] : edges)
    {
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
    }
    const auto end = std::find_if(neighbours.begin(), neighbours.end(),
                                  [](const auto &entry) { return entry.second.size() == 1; });
    if (end == neighbours.end())
      return false;
    std::set<unsigned int> seen;
    unsigned int at = end->first;
    for (bool goes_on = true; goes_on;)
    {
      seen.insert(at);
      goes_on = false;
      for (const unsigned int next : neighbours[at])
        if (seen.count(next) == 0)
        {
          at      = next;
          goes_on = true;
          break;
        }
    }
    return seen.size() == neighbours.size() && edges.size() + 1 == neighbours.size();
  }

  void check_body(const Section &section, const MeshFile &file)
  {
    BodyCheck(section, file).run();
  }

  void check_teeth(const Section &section, const MeshFile &file)
  {
    const auto at_edges                   = section.cells_at_edges();
    const std::vector<Section::Edge> feet = feet_of_teeth(section);
    for (const Section::Edge &foot : feet)
      for (const unsigned int cell : at_edges.at(foot))
        if (section.cells[cell].part != ids::tooth && section.cells[cell].part != ids::base)
          file.refuse("a tooth stands on the " + name_of_part(section.cells[cell].part) + ", at " +
                          in_words(section.points[foot.first]),
                      "let the part 'tooth' stand on the part 'base'");
    const bool has_teeth                  = section.has_part(ids::tooth);
    const std::vector<Section::Edge> tops = section.edges_named(ids::tooth_top);
    double highest_top = -std::numeric_limits<double>::max(), highest = highest_top, radius = 0.;
    for (const Section::Edge &top : tops)
      for (const unsigned int end : {top.first, top.second})
        highest_top = std::max(highest_top, section.points[end][1]);
    for (const Point<2> &x : section.points)
    {
      highest = std::max(highest, x[1]);
      radius  = std::max(radius, x[0]);
    }
    if (has_teeth && tops.empty())
      file.refuse("its teeth have no curve 'contact'",
                  "name their tops: Physical Curve(\"contact\")");
    if (!has_teeth)
      return;
    if (!is_one_line(feet))
      file.refuse("the foot of the tooth is in pieces",
                  "let the tooth stand on the base along one line");
    if (!is_one_line(tops))
      file.refuse("the curve 'contact' is in pieces", "name one line from end to end");
    if (highest > highest_top + places::file_rounding * radius)
      file.refuse("the curve 'contact' reaches z = " + in_millimetres(highest_top) +
                      ", below the highest point, z = " + in_millimetres(highest),
                  "name the highest face of the teeth, which the rotor touches");
  }
} // namespace ringmotor
