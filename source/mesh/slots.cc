// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/slots.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  double Slots::half_pitch() const
  {
    return numbers::PI / n_sectors;
  }

  double Slots::side(const double radius) const
  {
    return half_pitch() -
           (angle ? 0.5 * *angle : std::asin(0.5 * width / std::max(radius, inner_radius)));
  }

  double Slots::place(const double theta, const double radius) const
  {
    const double distance = std::abs(theta);
    if (!has_teeth())
      return theta / half_pitch();
    const double wall = side(radius);
    return std::copysign(
        distance <= wall ? distance / wall : 1. + (distance - wall) / (half_pitch() - wall), theta);
  }

  double Slots::angle_at(const double place, const double radius) const
  {
    if (!has_teeth())
      return place * half_pitch();
    const double wall = side(radius), s = std::abs(place);
    return std::copysign(s <= 1. ? s * wall : wall + (s - 1.) * (half_pitch() - wall), place);
  }

  template <int dim>
  Point<3> RevolvedManifold<dim>::pull_back(const Point<3> &position) const
  {
    const Point<3> x = cylindrical(position);
    return Point<3>(x[0], slots.place(x[1], x[0]), x[2]);
  }

  template <int dim>
  Point<3> RevolvedManifold<dim>::push_forward(const Point<3> &chart) const
  {
    return cartesian(Point<3>(chart[0], slots.angle_at(chart[1], chart[0]), chart[2]));
  }

  template class RevolvedManifold<2>;
  template class RevolvedManifold<3>;
} // namespace ringmotor
