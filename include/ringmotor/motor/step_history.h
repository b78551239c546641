// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_solver.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/repetition.h>
#include <ringmotor/motor/warp.h>

#include <deque>
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
   * further on; until then, and if those parts are no whole multiple of the step, the last steps
   * are extrapolated.
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

  private:
    /** Extrapolates from the last two steps. */
    StepEnd extrapolated(const double length) const;
    /** The end of a step close to a whole number of parts of a period ago, rotated; or none. */
    std::optional<StepEnd> repeated(const double length) const;

    const double period; ///< s, of the wave
    const unsigned int n_teeth;
    const Repetition repetition;
    std::deque<StepEnd> ends;
    StepEnd by_extrapolation;             ///< of the next step
    std::optional<StepEnd> by_repetition; ///< of the next step
    bool repeats = false;                 ///< whether the last one was closer to its repetition
  };
} // namespace ringmotor
