// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/motor.h>

#include <deal.II/grid/manifold.h>

namespace ringmotor
{
  /**
   * The exact shape of the stator's sector as the image of a box. Chart coordinates (rho, s, z):
   * rho runs from 0 on the inner to 1 on the outer side (the cross-section tapers with z), s from 0
   * at the tooth's centre via 1 at the slot wall to 2 at the cut theta = alpha/2 (negative for
   * theta < 0), z is the height in m. Slot walls are parallel planes, so the angle of s = 1 depends
   * on r; below the slots the same lines continue through the base. No cell may cross s = -1 or 1.
   * @p dim is that of the mesh: 3, or 2 for a shell on the stator's surface.
   */
  template <int dim>
  class SectorManifold : public dealii::ChartManifold<dim, 3, 3>
  {
  public:
    SectorManifold(const StatorGeometry &stator, const unsigned int n_teeth);

    dealii::Point<3> pull_back(const dealii::Point<3> &position) const override;
    dealii::Point<3> push_forward(const dealii::Point<3> &chart) const override;
    std::unique_ptr<dealii::Manifold<dim, 3>> clone() const override;

  private:
    /** Inner and outer radius in m of the cross-section at height z. */
    std::pair<double, double> radii(const double z) const;
    /** Angle of the slot wall at radius r. */
    double wall_angle(const double r) const;

    StatorGeometry stator;
    unsigned int n_teeth;
    double half_pitch;
  };
} // namespace ringmotor
