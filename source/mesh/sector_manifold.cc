// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/sector_manifold.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  template <int dim>
  SectorManifold<dim>::SectorManifold(const StatorGeometry &stator, const unsigned int n_teeth)
      : stator(stator), n_teeth(n_teeth), half_pitch(numbers::PI / n_teeth)
  {
  }

  template <int dim>
  Point<3> SectorManifold<dim>::pull_back(const Point<3> &position) const
  {
    const double z            = position[2];
    const double r            = std::hypot(position[0], position[1]);
    const double theta        = std::atan2(position[1], position[0]);
    const auto [inner, outer] = radii(z);
    const double wall         = wall_angle(r);
    const double distance     = std::abs(theta);
    const double s =
        distance <= wall ? distance / wall : 1. + (distance - wall) / (half_pitch - wall);
    return Point<3>((r - inner) / (outer - inner), std::copysign(s, theta), z);
  }

  template <int dim>
  Point<3> SectorManifold<dim>::push_forward(const Point<3> &chart) const
  {
    const auto [inner, outer] = radii(chart[2]);
    const double r            = inner + chart[0] * (outer - inner);
    const double wall         = wall_angle(r);
    const double s            = std::abs(chart[1]);
    const double distance     = s <= 1. ? s * wall : wall + (s - 1.) * (half_pitch - wall);
    const double theta        = std::copysign(distance, chart[1]);
    return Point<3>(r * std::cos(theta), r * std::sin(theta), chart[2]);
  }

  template <int dim>
  std::unique_ptr<Manifold<dim, 3>> SectorManifold<dim>::clone() const
  {
    return std::make_unique<SectorManifold<dim>>(stator, n_teeth);
  }

  template <int dim>
  std::pair<double, double> SectorManifold<dim>::radii(const double z) const
  {
    // The ceramic ring (z < 0) has vertical sides.
    const double fraction = std::max(0., z) / (stator.base_thickness + stator.tooth_height);
    return {
        stator.base_inner_radius + fraction * (stator.tip_inner_radius - stator.base_inner_radius),
        stator.base_outer_radius + fraction * (stator.tip_outer_radius - stator.base_outer_radius)};
  }

  template <int dim>
  double SectorManifold<dim>::wall_angle(const double r) const
  {
    return half_pitch - std::asin(0.5 * stator.slot_width / r);
  }

  template class SectorManifold<2>;
  template class SectorManifold<3>;
} // namespace ringmotor
