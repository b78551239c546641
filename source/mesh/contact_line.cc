// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/contact_line.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>

#include <deal.II/base/numbers.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  double RadialRange::area() const
  {
    return is_empty() ? 0. : numbers::PI * (outer * outer - inner * inner);
  }

  RadialRange RadialRange::common(const RadialRange &other) const
  {
    return {std::max(inner, other.inner), std::min(outer, other.outer)};
  }

  namespace
  {
    /** The ends of the edges that can touch. */
    std::vector<Point<2>> ends_in_contact(const RevolvedBody &body)
    {
      std::vector<Point<2>> ends;
      for (const types::boundary_id name : {ids::tooth_top, ids::lip})
        for (const Section::Edge &edge : body.section.edges_named(name))
          for (const unsigned int end : {edge.first, edge.second})
            ends.push_back(body.section.points[end]);
      const Section::ShellLine &shell = body.section.shell;
      for (unsigned int i = 0; shell.n_in_contact > 0 && i <= shell.n_in_contact; ++i)
        ends.emplace_back(shell.points[i][0], shell.points[i][1] - 0.5 * body.shell_thickness);
      return ends;
    }
  } // namespace

  RadialRange radii_around(const std::vector<Point<2>> &places)
  {
    if (places.empty())
      return {};
    const auto [inner, outer] =
        std::minmax_element(places.begin(), places.end(),
                            [](const Point<2> &a, const Point<2> &b) { return a[0] < b[0]; });
    return {(*inner)[0], (*outer)[0]};
  }

  ContactLine contact_line_through(const std::vector<Point<2>> &places)
  {
    if (places.empty())
      return {};
    const auto [lowest, highest] =
        std::minmax_element(places.begin(), places.end(),
                            [](const Point<2> &a, const Point<2> &b) { return a[1] < b[1]; });
    return {radii_around(places), (*lowest)[1], (*highest)[1]};
  }

  ContactLine contact_line(const RevolvedBody &body)
  {
    return contact_line_through(ends_in_contact(body));
  }

  std::vector<RadialRange> joined(std::vector<RadialRange> ranges)
  {
    std::sort(ranges.begin(), ranges.end(),
              [](const RadialRange &a, const RadialRange &b) { return a.inner < b.inner; });
    std::vector<RadialRange> joined;
    for (const RadialRange &range : ranges)
      if (!joined.empty() && range.inner <= joined.back().outer * (1. + places::rounding))
        joined.back().outer = std::max(joined.back().outer, range.outer);
      else
        joined.push_back(range);
    return joined;
  }

  std::vector<RadialRange> radii_on_felt(const RevolvedBody &stator)
  {
    std::vector<RadialRange> all;
    for (const types::boundary_id name : {ids::bottom, ids::skin})
      for (const Section::Edge &edge : stator.section.edges_named(name))
        all.push_back(
            radii_around({stator.section.points[edge.first], stator.section.points[edge.second]}));
    return joined(std::move(all));
  }
} // namespace ringmotor
