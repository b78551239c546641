// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

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

    double crest_speed;  ///< rad/s
    double borne_torque; ///< N m, that of sliding friction
    double stall_torque; ///< N m

    /** The fastest speed, the torque at stall, the largest loss and number of teeth; 1 for the
     * fraction that sticks. @param largest absolute value of the quantity at all points */
    double of(const std::string &quantity, const double largest) const;
  };
} // namespace ringmotor
