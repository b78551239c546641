// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/curve_point.h>
#include <ringmotor/points/discretisation.h>
#include <ringmotor/results/quantity.h>
#include <ringmotor/sensitivity/stator_on_mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace ringmotor
{
  /** What is known of each nearby motor. */
  struct SensitiveQuantity
  {
    std::string name; ///< in all outputs
    Unit unit;
  };

  /** The frequency of the wave without rotor, the speed without load and the torque at stall, then
   * speed, friction loss and efficiency at half of the motor's own stall torque. */
  const std::vector<SensitiveQuantity> &sensitive_quantities();

  /**
   * A motor and others that differ little from it, all on the same meshes with the same steps: in
   * their ratios most of the discretisation errors cancel. Of another motor, only what its entries
   * change is computed again, and its operating points are searched from those of the first one.
   */
  class NearbyMotors
  {
  public:
    /** Computes the first motor.
     * @param stators of a first motor without effects that are `auto`; steady; must outlive this
     * object
     * @throws ComputationError if an operating point is not found */
    NearbyMotors(const NearbyStators &stators, const Discretisation &discretisation);

    /** The values of sensitive_quantities() of the first motor, in SI units. */
    const std::vector<double> &values() const { return first_values; }

    /** Those of another motor.
     * @throws UserError for a motor that cannot be made
     * @throws ComputationError if its meshes have other cells, or an operating point is not found
     */
    std::vector<double> values_of(const Parameters &other) const;

    /** The first motor, which has no effects that are `auto`. */
    const Parameters &parameters() const { return stators.parameters(); }

  private:
    /** The operating points to which the quantities belong. */
    struct Points
    {
      CurvePoint stalled, half_loaded, without_load;
    };

    std::unique_ptr<const CondensedMotor> condensed(const Parameters &other,
                                                    const StatorOnMesh &on) const;
    Points points_of_first() const;
    /** @param starts those of the first motor; null for these themselves */
    Points points_of(const Parameters &other, const StatorOnMesh &on, const CondensedMotor &motor,
                     const Points *starts) const;
    std::vector<double> values_of(const Parameters &other, const StatorOnMesh &on,
                                  const Points &points) const;

    const NearbyStators &stators;
    const Discretisation discretisation;
    std::unique_ptr<const CondensedMotor> motor;
    Points points;
    std::vector<double> first_values;
  };
} // namespace ringmotor
