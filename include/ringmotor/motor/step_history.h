// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_solver.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/repetition.h>
#include <ringmotor/motor/warp.h>

#include <deque>
#include <limits>
#include <optional>
#include <vector>

namespace ringmotor
{
  /** The state of a marched motor at the end of a step. */
  struct StepEnd : StepState ///< without the rotation among its rigid motions
  {
    double time   = 0.; ///< s
    double length = 0.; ///< s, of the step
  };

  /** The same on a ring rotated by some teeth: what was at tooth 0 is at tooth @p by. */
  StepEnd turned(const StepEnd &end, const unsigned int by, const unsigned int n_teeth);

  /**
   * The states at the end of the last steps of a marched motor, and a prediction of the next one.
   * Once the motor has settled, it repeats the motion of some parts of a period ago, a few teeth
   * further on; until then, and where no step ended at such a time, the last steps are
   * extrapolated.
   */
  class StepHistory
  {
  public:
    StepHistory(const CondensedMotor &motor, const Warp &warp);

    /** Adds the end of the last step, or a state at rest to start from. */
    void add(StepEnd end);
    const StepEnd &last() const { return ends.back(); }

    /** Predicts the end of a step of some length (s): by repetition or by extrapolation, whichever
     * was closer in the last step. */
    const StepEnd &predict(const double length);

    /** The time (s) from which on the motion has repeated itself, by the forces of the steps so
     * far; infinite if the last step did not. */
    double repeats_from() const { return repeated_from; }
    /** The difference of forces, relative to them, up to which a motion repeats itself. */
    static constexpr double repetition_tolerance = 1e-4;

  private:
    /** An earlier step, rotated, and how long ago it was (s). */
    struct Repeated
    {
      StepEnd end;
      double since;
    };

    /** Extrapolates from the last two steps. */
    StepEnd extrapolated(const double length) const;
    /** The end of a step close to a whole number of parts of a period ago, rotated; or none. */
    std::optional<Repeated> repeated(const double length) const;

    const double period; ///< s, of the wave
    const unsigned int n_teeth;
    const Repetition repetition;
    std::deque<StepEnd> ends;
    StepEnd by_extrapolation;              ///< of the next step
    std::optional<Repeated> by_repetition; ///< of the next step
    bool repeats         = false;          ///< whether the last one was closer to its repetition
    double repeated_from = std::numeric_limits<double>::infinity(); ///< s
  };
} // namespace ringmotor
