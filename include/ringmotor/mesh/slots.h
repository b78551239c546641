// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/grid/manifold.h>

#include <optional>

namespace ringmotor
{
  /** The slots between the teeth of a ring. */
  struct Slots
  {
    unsigned int n_sectors      = 1;
    double width                = 0.; ///< m, between parallel walls
    std::optional<double> angle = {}; ///< rad, between radial walls instead
    /** m, where teeth begin; lines that continue their sides further inwards are radial. Without
     * teeth: 0. */
    double inner_radius = 0.;

    double half_pitch() const;
    /** m, where the teeth begin. */
    double half_width() const { return 0.5 * (angle ? *angle * inner_radius : width); }
    bool has_teeth() const { return inner_radius > 0.; }
    /** The angle (rad) of the side of a tooth over its centre at a radius (m). */
    double side(const double radius) const;
    /** The place along theta on the scale of Revolution::lines, and back. */
    double place(const double theta, const double radius) const;
    double angle_at(const double place, const double radius) const;
  };

  /**
   * The exact shape of revolved cells. Chart coordinates are r, the place along theta (see Slots)
   * and z: lines of a section stay straight, sides of slots stay planes. No cell may cross the side
   * of a slot. @p dim is that of the mesh: 3, or 2 for a shell.
   */
  template <int dim>
  class RevolvedManifold : public dealii::ChartManifold<dim, 3, 3>
  {
  public:
    explicit RevolvedManifold(const Slots &slots) : slots(slots) {}

    dealii::Point<3> pull_back(const dealii::Point<3> &position) const override;
    dealii::Point<3> push_forward(const dealii::Point<3> &chart) const override;
    std::unique_ptr<dealii::Manifold<dim, 3>> clone() const override
    {
      return std::make_unique<RevolvedManifold<dim>>(slots);
    }

  private:
    const Slots slots;
  };
} // namespace ringmotor
