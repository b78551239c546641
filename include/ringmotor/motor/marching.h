// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/steady.h>
#include <ringmotor/motor/step_history.h>

namespace ringmotor
{
  /**
   * Marches a motor through time in implicit steps, from a rotor that rests without friction on the
   * teeth in their positions at time 0, or from a steady state. For rings that are not uniform, for
   * the start, and for steps of any length.
   */
  class MarchingDriver
  {
  public:
    /** The bodies of @p motor must outlive this object and all its states. */
    MarchingDriver(const MotorInUse &motor, const Friction &friction, const Warp &warp,
                   const double preload);

    /** Continues from the first time sample of a steady state, with steps of its length. */
    MarchingDriver(const MotorInUse &motor, const Friction &friction, const OperatingState &steady);

    /** Advances by one step (s) under a load. @throws ComputationError */
    OperatingState step(const RotorLoad &load, const double length);

    /** Damps all motions that have inertia with a loss factor, at least that of the rotor itself:
     * transients of the start decay in fewer periods. The motion of the rotor as a whole, which has
     * no natural frequency, is damped like a mode with the frequency of the wave. */
    void damp(const double loss_factor);

    double time() const { return history.last().time; }

  private:
    /** Removes the static limit of contact points that exceed it, according to the law. Returns
     * whether there are any. */
    bool lose_static_limits(const ContactSolution &solution,
                            std::vector<FrictionMemory> &limits) const;

    /** The data of the next step: positions at its begin and the response with inertia. */
    TimeStep next_step(const double length);

    const MotorInUse in_use;
    const CondensedMotor &motor; ///< its bodies
    const Friction friction;
    const Warp warp;
    std::optional<MarchedModes> modes;                 ///< of bodies with inertia
    std::optional<MarchedRigidMotions> rigid_motions;  ///< of a rotor that moves as a whole
    std::shared_ptr<const BlockCompliance> compliance; ///< with modes, in steps of #step_length
    double step_length = 0.;
    StepHistory history;
    RowSolver solver;                   ///< its factors serve several steps
    std::vector<PointVector> positions; ///< at the end of the last step
    std::vector<FrictionMemory> memory;
  };
} // namespace ringmotor
