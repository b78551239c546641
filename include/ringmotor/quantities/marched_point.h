// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/marching.h>
#include <ringmotor/quantities/torque_speed.h>

#include <optional>

namespace ringmotor
{
  /**
   * How far the last of several means over equal spans of time may be from where they lead to: the
   * larger one of the last two changes or, where changes shrink slowly, what is still to come if
   * they go on shrinking as they do. Infinite for fewer than three means.
   */
  double remaining_change(const std::vector<double> &means);

  /** Some equal steps of a marched motor. */
  struct MarchedSpan
  {
    OperatingPoint mean;  ///< over its steps, but for the first one of all
    ContactFields fields; ///< at the ends of all parts of its steps
  };

  /** A motor on its way through time under one load, which comes after the first span. */
  class MarchedRun
  {
  public:
    /** @p motor must outlive this object and all that it returns. */
    MarchedRun(const Parameters &parameters, const CondensedMotor &motor,
               const PointRequest &request, const unsigned int n_joined = 1);

    /** Goes on by some steps of a length (s), as many of which as possible are joined to one; these
     * fall into `Time/Snapshots` parts each. @throws ComputationError */
    MarchedSpan advance(const unsigned int n_steps, const double length);

    /** See MarchingDriver::damp(). */
    void damp(const double loss_factor) { driver.damp(loss_factor); }

    /** Has the certificate of all steps so far, and what it took to find them. */
    const CurvePoint &effort() const { return taken; }

  private:
    /** Goes on by a part of a step. @returns nothing for the first one of all, before which there
     * is no energy, and which has no torque */
    std::optional<OperatingPoint> add_step(const double length, ContactFields &fields);

    const RotorLoad load;
    const unsigned int n_parts;  ///< of a step
    const unsigned int n_joined; ///< steps
    MarchingDriver driver;
    OperatingState last;
    CurvePoint taken;
  };

  /**
   * Finds an operating point by marching. Averages over whole periods of the solution once their
   * means have settled to a tenth of `Accuracy/Contact target`, the steps being shortened so that a
   * period is a whole number of them; the fields are those of the last period. If `Time` gives
   * steps to average over, the point has these and the fields of all steps that are asked for, and
   * what the settled means differ from it by is an error of it, see CurvePoint::window; it is left
   * at zero if @p tells_window is false, which saves the steps until the means have settled. @p
   * n_joined of these steps are joined to one, as far as the window allows.
   *
   * @throws ComputationError if a step fails or the means do not settle
   */
  CurvePoint find_marched(const Parameters &parameters, const CondensedMotor &motor,
                          const PointRequest &request, const unsigned int n_joined = 1,
                          const bool tells_window = true);
} // namespace ringmotor
