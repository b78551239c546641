// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/steady.h>

namespace ringmotor
{
  /**
   * Marches a motor through time in implicit steps, from a rotor that lies without friction on the
   * teeth as they stand at the time 0. For rings that are not uniform, for the start, and for steps
   * of any length.
   */
  class MarchingDriver
  {
  public:
    /** @p motor must outlive this object and all its states. */
    MarchingDriver(const CondensedMotor &motor, const Friction &friction, const Warp &warp,
                   const double preload);

    /** Goes on by one step (s) under a load. @throws ComputationError */
    OperatingState step(const RotorLoad &load, const double length);

    double time() const { return now; }

  private:
    /** A point that exceeds its static limit falls to the dynamic one and stays there. Returns
     * whether there is one. */
    bool lose_static_limits(const ContactSolution &solution,
                            std::vector<FrictionMemory> &limits) const;

    /** What a step left. */
    struct Left
    {
      ContactState state;              ///< without the turn
      std::vector<PointVector> motion; ///< gaps, and slips in the step; empty if there was none
      double length = 0.;              ///< s
    };
    /** What the next step of some length will leave if all goes on as in the last two. */
    Left predicted(const double length) const;

    const CondensedMotor &motor;
    const Friction friction;
    const Warp warp;
    double now = 0.;
    Left last, before;                  ///< the last step, and the one before
    std::vector<PointVector> positions; ///< at the end of the last step
    std::vector<FrictionMemory> memory;
    double last_speed = 0.; ///< rad/s
  };
} // namespace ringmotor
