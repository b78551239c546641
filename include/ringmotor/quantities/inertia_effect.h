// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/quantities/torque_speed.h>

namespace ringmotor
{
  /** What the rotor's inertia does to the motor, at least approximately. */
  struct InertiaEffect
  {
    double speed    = 0.; ///< rad/s, the larger change, without load and at half the stall torque
    double torque   = 0.; ///< N m, change at stall; where speeds are given, also at half of it
    double loss     = 0.; ///< relative change of the friction loss, the larger one of both
    double relative = 0.; ///< the largest of speed and torque, by those at no load and at stall
    double seconds  = 0.; ///< that it took to find this out

    /** What leaving it out may cost a point. */
    PointError left_out_of(const CurvePoint &point) const;
  };

  /**
   * Compares operating points of a uniform ring with and without inertia on the coarsest mesh, with
   * few modes. Infinite if there is a state without inertia, but none with it.
   * @throws ComputationError if none is found without inertia
   */
  InertiaEffect inertia_effect(const Parameters &parameters, const StatorWave &wave);
} // namespace ringmotor
