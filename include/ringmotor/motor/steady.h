// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/ring_contact.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** Where on the curve, for messages: "at 50 mN m", "at 20 rpm". */
  std::string text_of(const RotorLoad &load);

  /** A motor at one operating point. */
  struct OperatingState
  {
    std::shared_ptr<const RingContact> contact;
    ContactSolution solution;                      ///< with memory and speed
    ModalPower modal_power{};                      ///< of a motor with modes
    std::vector<PointVector> modal_motion{};       ///< m, of all contact points in these modes
    std::vector<std::complex<double>> vibration{}; ///< of these modes, see SteadyInertia::vibration
    /** The states that it alternates with where no memory of the friction law agrees with itself.
     */
    std::vector<OperatingState> others{};
  };

  /**
   * Finds steady states of a motor, each starting from the previous one. The sliding history
   * travels with the wave: the memory of a contact point is the state one step earlier, which is
   * that of RingContact::earlier() now.
   */
  class SteadyDriver
  {
  public:
    /** The bodies of @p motor must outlive this object and all its states. */
    SteadyDriver(const MotorInUse &motor, const Friction &friction, const SteadyStep &step);

    /** From now on gives up a state with inertia for which a dozen proximal points do not suffice,
     * since a long chain of them takes a minute. */
    void search_briefly() { last_resort = Fallback::few_proximal_points; }

    /** Changes the wave; the next search starts from the last state. */
    void set_wave(const WaveAtNodes &wave);

    /** Ways from one state with inertia to another one, in the order in which they are tried. */
    enum class Way
    {
      at_once,
      by_some_damping,  ///< that is reduced in stages
      by_strong_damping ///< the same
    };

    /**
     * The state under a load.
     * @param first_way skips those before it; tests see with it that all lead to the same state
     * @throws ComputationError if no state is found; the message says what was tried
     */
    OperatingState at(const RotorLoad &load, const Way first_way = Way::at_once);

    /** Whether there is a state from which the next search starts. */
    bool has_state() const { return next.has_value(); }

    /** Sets a known state as the start of the next search. If it has other time samples, those in
     * between are interpolated. Its memory is not used. */
    void go_on_from(const RotorLoad &load, const StepState &known);
    /** Adds the change from one state to another to the known one, as the start of the next search:
     * both with other time samples or of a similar motor. Where the search fails from there, it
     * starts from the latter. */
    void go_on_by_change(const RotorLoad &load, const StepState &from, const StepState &to);
    /** Forgets it. */
    void start_from_rest()
    {
      next.reset();
      other.reset();
    }

  private:
    std::shared_ptr<const SteadyDynamics> with_inertia(const RingDynamics &of_modes) const;
    OperatingState find(const RotorLoad &load, StepState start) const;
    OperatingState find(const RotorLoad &load, StepState start,
                        std::shared_ptr<const SteadyDynamics> of_modes,
                        const Fallback fallback = Fallback::proximal_points) const;
    /** The state as the start of the search for another one. */
    static StepState start_at(const OperatingState &state);
    /** From a nearby state by Newton's method alone, through states with inertia and 3^n, ..., 9, 3
     * times the loss factor. */
    OperatingState find_through(const RotorLoad &load, StepState start,
                                const unsigned int n_stages) const;
    /** From #next or #other; with inertia through as few such stages as lead to the state, because
     * there may be several, and strong damping may lead to another one; at last by_damping(). */
    OperatingState find_or_damp(const RotorLoad &load, const Way first_way) const;
    /** From another state, which has the dynamics @p of_start, through states with inertia and
     * decreasing damping. */
    StepState by_damping(const RotorLoad &load, StepState start,
                         const RingDynamics &of_start) const;
    /** From a state with the dynamics @p begin to that with @p end: by Newton's method alone, in
     * as few steps between them as it can; if even short ones fail, by #last_resort. */
    StepState follow(const RotorLoad &load, StepState start, const RingDynamics &begin,
                     const RingDynamics &end) const;
    /** A start near the state under a law that decreases with the distance slipped: the last of a
     * sequence of states, in each of which the friction coefficients follow from memory and slip in
     * the previous one. Adds the number of systems solved to @p n_iterations. */
    StepState by_coefficients(const RingContact &contact, StepState start, RowSolver &solver,
                              unsigned int &n_iterations) const;
    /** The start of a search without any known state: with several time samples the state with a
     * single one, in a fraction of their time; else the motor pressed down, and with inertia
     * through the state without it. */
    StepState from_rest(const RotorLoad &load) const;
    /** The start from a state, with the time samples of @p contact. */
    StepState start_from(const RingContact &contact, const RotorLoad &load,
                         const StepState &known) const;
    /** From a state at the time samples of @p coarse to those of @p fine, with forces interpolated
     * linearly. */
    static StepState at_other_samples(const RingContact &coarse, const StepState &known,
                                      const RingContact &fine);

    MotorInUse motor;
    const Friction friction;
    const SteadyStep step;
    const std::shared_ptr<const ModesByShapes> modes; ///< null without inertia
    std::shared_ptr<const SteadyDynamics> dynamics;   ///< of a motor with inertia
    std::optional<StepState> next, other;             ///< to start from, and if that fails
    Fallback last_resort = Fallback::proximal_points; ///< for states with inertia
  };

  /** The distance that each contact point has slipped (m) since it stuck or came into contact, at
   * the end of the step; @p earlier gives the same at its begin. */
  std::vector<FrictionMemory> next_memory(const StepState &solution,
                                          const std::vector<FrictionMemory> &earlier);
} // namespace ringmotor
