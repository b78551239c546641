// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/steady.h>
#include <ringmotor/motor/step_history.h>

namespace ringmotor
{
  /**
   * Marches a motor through time in implicit steps, from a rotor that lies without friction on the
   * teeth as they stand at the time 0, or from a steady state. For rings that are not uniform, for
   * the start, and for steps of any length.
   */
  class MarchingDriver
  {
  public:
    /** @p motor must outlive this object and all its states. */
    MarchingDriver(const CondensedMotor &motor, const Friction &friction, const Warp &warp,
                   const double preload);

    /** Goes on from the first sample of a steady state, with steps of its length. */
    MarchingDriver(const CondensedMotor &motor, const Friction &friction,
                   const OperatingState &steady);

    /** Goes on by one step (s) under a load. @throws ComputationError */
    OperatingState step(const RotorLoad &load, const double length);

    /** Damps all motions that have inertia with a loss factor, but not less than the rotor itself
     * does: transients of the start die out in fewer periods. The rotor as a whole, which has no
     * frequency of its own, is damped as a mode with the wave's. */
    void damp(const double loss_factor);

    double time() const { return history.last().time; }

  private:
    /** Lets points that exceed their static limit lose it, as the law says. Returns whether there
     * is one. */
    bool lose_static_limits(const ContactSolution &solution,
                            std::vector<FrictionMemory> &limits) const;

    /** The step from here, so far as the rotor's inertia decides it. */
    TimeStep next_step(const double length);

    const CondensedMotor &motor;
    const Friction friction;
    const Warp warp;
    std::optional<MarchedModes> modes;                 ///< of bodies with inertia
    std::optional<MarchedRigidMotions> rigid_motions;  ///< of a rotor that moves as a whole
    std::shared_ptr<const BlockCompliance> compliance; ///< with them, in steps of #step_length
    double step_length = 0.;
    StepHistory history;
    std::vector<PointVector> positions; ///< at the end of the last step
    std::vector<FrictionMemory> memory;
  };
} // namespace ringmotor
