// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/places.h>

#include <algorithm>
#include <limits>

namespace ringmotor
{
  std::pair<double, double> range_of_radii(const dealii::Triangulation<3> &triangulation)
  {
    double inner = std::numeric_limits<double>::max(), outer = 0.;
    for (const dealii::Point<3> &vertex : triangulation.get_vertices())
    {
      inner = std::min(inner, cylindrical(vertex)[0]);
      outer = std::max(outer, cylindrical(vertex)[0]);
    }
    return {inner, outer};
  }
} // namespace ringmotor
