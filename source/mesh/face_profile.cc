// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/face_profile.h>
#include <ringmotor/mesh/places.h>

#include <algorithm>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  double FaceProfile::height(const double radius) const
  {
    if (points.empty() || radius <= points.front()[0])
      return 0.;
    const auto next = std::find_if(points.begin(), points.end(),
                                   [&](const Point<2> &x) { return x[0] > radius; });
    if (next == points.end())
      return points.back()[1] - points.front()[1];
    const Point<2> &from = *std::prev(next);
    const double share   = (radius - from[0]) / ((*next)[0] - from[0]);
    return from[1] + share * ((*next)[1] - from[1]) - points.front()[1];
  }

  double FaceProfile::depth() const
  {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(),
                            [](const Point<2> &a, const Point<2> &b) { return a[1] < b[1]; });
    return points.empty() ? 0. : (*high)[1] - (*low)[1];
  }

  namespace
  {
    std::set<unsigned int> ends_of(const Section &section, const types::boundary_id contact)
    {
      std::set<unsigned int> ends;
      for (const Section::Edge &edge : section.edges_named(contact))
        ends.insert({edge.first, edge.second});
      return ends;
    }
  } // namespace

  FaceProfile face_profile(const Section &section, const types::boundary_id contact)
  {
    FaceProfile profile;
    for (const unsigned int end : ends_of(section, contact))
      profile.points.push_back(section.points[end]);
    std::sort(profile.points.begin(), profile.points.end(),
              [](const Point<2> &a, const Point<2> &b) { return a[0] < b[0]; });
    if (!profile.points.empty() &&
        profile.depth() <= places::file_rounding * profile.points.back()[0])
      profile.points.clear();
    return profile;
  }

  Section levelled(Section section, const types::boundary_id contact, const FaceProfile &profile)
  {
    const std::vector<Point<2>> &points = profile.points;
    if (points.empty() ||
        profile.depth() > most_depth_of_profile * (points.back()[0] - points.front()[0]))
      return section;
    double area = 0.;
    for (std::size_t i = 1; i < points.size(); ++i)
      area += 0.5 * (points[i][1] + points[i - 1][1]) * (points[i][0] - points[i - 1][0]);
    for (const unsigned int end : ends_of(section, contact))
      section.points[end][1] = area / (points.back()[0] - points.front()[0]);
    return section;
  }
} // namespace ringmotor
