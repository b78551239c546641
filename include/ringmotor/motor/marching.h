// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/steady.h>
#include <ringmotor/motor/step_history.h>

namespace ringmotor
{
  /** What a motor marched through time carries from one step to the next. */
  struct MarchedState
  {
    StepEnd end;                                ///< of the last step
    std::vector<PointVector> positions;         ///< at its end, see RingContact::positions()
    std::vector<FrictionMemory> memory;         ///< for the next step, by point
    std::vector<std::vector<ModalState>> modes; ///< by nodal diameter; empty without modes
    /** Of a rotor with mass, see RingContact for their order; else empty. */
    std::vector<RigidMotionState> rigid_motions;

    bool is_known() const { return !positions.empty(); }

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &end.state.force &end.state.rigid &end.motion &end.status &end.speed &end.time &end
          .length;
      archive &positions &memory &modes &rigid_motions;
    }
  };

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

    /** Continues from the state of a similar motor, with the same modes and contact points. */
    MarchingDriver(const MotorInUse &motor, const Friction &friction, const Warp &warp,
                   const MarchedState &from);

    MarchedState state() const;

    /** Advances by one step (s) under a load. @throws ComputationError if no state is found; this
     * object is then as before */
    OperatingState step(const RotorLoad &load, const double length,
                        const Fallback fallback = Fallback::proximal_points);

    /** Damps all motions that have inertia, whatever their frequencies, like a mode with that of
     * the wave and this loss factor: transients die out in fewer periods. */
    void damp(const double loss_factor);

    double time() const { return history.last().time; }
    /** See StepHistory::repeats_from(). */
    double repeats_from() const { return history.repeats_from(); }

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
