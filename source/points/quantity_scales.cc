// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/quantity_scales.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  double QuantityScales::of(const std::string &quantity, const double largest) const
  {
    if (quantity == "speed")
      return std::max(largest, share * crest_speed);
    if (quantity == "torque")
      return std::max(std::abs(stall_torque), share * borne_torque);
    return quantity == "stick_fraction" ? 1. : largest;
  }

  QuantityScales scales_of(const Parameters &parameters, const CondensedMotor &motor,
                           const double amplitude, const double stall_torque)
  {
    return {motor.crest_speed() * (amplitude / motor.wave.amplitude),
            parameters.friction.dynamic_coefficient * parameters.loading.preload *
                motor.nodes.front().radius,
            stall_torque};
  }
} // namespace ringmotor
