// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/ring_contact.h>

#include <memory>
#include <optional>
#include <vector>

namespace ringmotor
{
  /** A motor at one operating point. */
  struct OperatingState
  {
    std::shared_ptr<const RingContact> contact;
    ContactSolution solution;
    std::vector<FrictionMemory> memory;      ///< of each point, at the begin of its step
    ModalPower modal_power{};                ///< of a rotor with inertia
    std::vector<PointVector> modal_motion{}; ///< m, of it at all points, in its modes
  };

  /**
   * Finds steady states of a motor, one after the other: each starts from the one before. Sliding
   * history travels with the wave: what a point remembers is what happened one step earlier at the
   * point that stands for it then.
   */
  class SteadyDriver
  {
  public:
    /** @p motor must outlive this object and all its states. */
    SteadyDriver(const CondensedMotor &motor, const Friction &friction, const SteadyStep &step);

    /**
     * The state under a load.
     * @throws ComputationError if no state is found; the message says what was tried
     */
    OperatingState at(const RotorLoad &load);

    /** Whether there is a state from which the next one is looked for. */
    bool has_state() const { return next.has_value(); }

    /** Takes a known state, in which the rotor turns with @p speed (rad/s), as that from which the
     * next one is to be found. Where it has other samples, those between follow from them. Of
     * @p solution the state, the motion and the status of all points are used. */
    void go_on_from(const RotorLoad &load, const ContactSolution &solution, const double speed);

  private:
    /** From where a state is looked for. */
    struct Start
    {
      ContactState state;
      std::vector<PointVector> motion; ///< gap and slip, if they are known
      std::vector<FrictionMemory> memory;
      double speed; ///< rad/s
    };
    OperatingState find(const RotorLoad &load, Start start) const;
    OperatingState find(const RotorLoad &load, Start start,
                        std::shared_ptr<const SteadyDynamics> with_inertia,
                        const Fallback fallback = Fallback::proximal_points) const;
    /** From a state nearby; with inertia, if Newton's method alone does not lead from it, from
     * states with damping that falls: there the proximal point algorithm takes long, and may fail.
     */
    OperatingState find_or_damp(const RotorLoad &load, const Start &start) const;
    /** From another state, which may be one without inertia: by states with inertia and damping
     * that falls. */
    Start by_damping(const RotorLoad &load, Start start) const;
    /** A start that is near the state under a law that falls with the distance slipped: the last of
     * a chain of states, in each of which points have the coefficients that belong to memory and
     * slip in the one before. Adds the systems that are solved. */
    Start by_coefficients(const RingContact &contact, Start start, RowSolver &solver,
                          unsigned int &n_iterations) const;
    Start from_rest(const RotorLoad &load) const;
    /** From a state at the samples of @p coarse, between which forces grow linearly, to those of
     * @p fine. */
    static Start at_other_samples(const RingContact &coarse, const ContactSolution &solution,
                                  const RingContact &fine, const double speed);

    const CondensedMotor &motor;
    const Friction friction;
    const SteadyStep step;
    std::shared_ptr<const SteadyDynamics> dynamics; ///< of a motor with inertia
    std::optional<Start> next;
  };

  /** How far each point has slipped (m) since it stuck or came into contact, at the end of the
   * step;
   * @p earlier gives the same at its begin. */
  std::vector<FrictionMemory> next_memory(const ContactSolution &solution,
                                          const std::vector<FrictionMemory> &earlier);
} // namespace ringmotor
