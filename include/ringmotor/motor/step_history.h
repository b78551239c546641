// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_problem.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/repetition.h>
#include <ringmotor/motor/warp.h>

#include <deque>
#include <optional>
#include <vector>

namespace ringmotor
{
  /** What a step of a marched motor left. */
  struct StepEnd
  {
    double time   = 0.;              ///< s
    double length = 0.;              ///< s, of the step
    double speed  = 0.;              ///< rad/s
    ContactState state;              ///< without the turn
    std::vector<PointVector> motion; ///< gaps, and slips in the step; empty if there was none
  };

  /** The same on a ring that is turned by some teeth: what was at tooth 0 is at tooth @p by. */
  StepEnd turned(const StepEnd &end, const unsigned int by, const unsigned int n_teeth);

  /**
   * What the last steps of a marched motor left, and what the next one is likely to leave. Once the
   * motor has settled, it does what it did some parts of a period ago, a few teeth further on;
   * until then, and in steps of which those parts are no whole multiple, it goes on as it did last.
   */
  class StepHistory
  {
  public:
    StepHistory(const CondensedMotor &motor, const Warp &warp);

    /** Takes in what the last step left, or a state at rest to start from. */
    void add(StepEnd end);
    const StepEnd &last() const { return ends.back(); }

    /** What a step of some length (s) will leave: by repetition or by extrapolation, whichever was
     * closer in the last step. */
    const StepEnd &predict(const double length);

  private:
    /** Goes on as in the last two steps. */
    StepEnd extrapolated(const double length) const;
    /** A step nearly a whole number of parts of a period ago, turned; none if there is none. */
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
