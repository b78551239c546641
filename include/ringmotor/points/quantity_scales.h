// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/parameters/parameters.h>

#include <string>

namespace ringmotor
{
  /** To what errors of the quantities that `Accuracy/Quantities` may list are related. */
  struct QuantityScales
  {
    /** A rotor pressed so hard that it barely moves has neither a speed nor a torque to which
     * errors could be related. They are then related to this fraction of the speed of the wave's
     * crests and of the torque that friction can bear. */
    static constexpr double share = 0.5;

    double crest_speed  = 0.; ///< rad/s
    double borne_torque = 0.; ///< N m, if all contact points slip the same way
    double stall_torque = 0.; ///< N m

    /** The fastest speed, the torque at stall, the largest loss and number of teeth; 1 for the
     * fraction that sticks. @param largest absolute value of the quantity at all points */
    double of(const std::string &quantity, const double largest) const;
  };

  /** Those of a motor. @param amplitude m, the largest of its wave @param stall_torque N m */
  QuantityScales scales_of(const Parameters &parameters, const CondensedMotor &motor,
                           const double amplitude, const double stall_torque);
} // namespace ringmotor
