// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/marching.h>
#include <ringmotor/points/curve_point.h>

#include <optional>

namespace ringmotor
{
  /**
   * How far the last of several means over equal spans of time may be from their limit: the larger
   * one of the last two changes or, where changes shrink slowly, the change to come if they
   * continue to shrink at this rate. Infinite for fewer than three means.
   */
  double remaining_change(const std::vector<double> &means);

  /** How far the last of many means may be from their limit if they do not converge but wander in a
   * narrow band: twice the range of their later half; infinite with fewer than twenty. */
  double wandering(const std::vector<double> &means);

  /** Some equal steps of a marched motor. */
  struct MarchedSpan
  {
    OperatingPoint mean;  ///< over its steps, except the very first one of a run
    ContactFields fields; ///< at the ends of all parts of its steps
  };

  /** A motor marched through time under one load, whose torque starts after the first part-step. */
  class MarchedRun
  {
  public:
    /** The bodies of @p motor must outlive this object and all that it returns. */
    MarchedRun(const Parameters &parameters, const MotorInUse &motor, const PointRequest &request,
               const unsigned int n_joined = 1);

    /** Advances by some steps of a length (s). As many of these as possible are joined into one,
     * which is divided into `Time/Snapshots` parts. @throws ComputationError */
    MarchedSpan advance(const unsigned int n_steps, const double length);

    /** See MarchingDriver::damp(). */
    void damp(const double loss_factor) { driver.damp(loss_factor); }

    /** The certificate of all steps so far, and the effort to find them. */
    const CurvePoint &effort() const { return taken; }

  private:
    /** Advances by a part of a step. @returns nothing for the very first one, before which there is
     * no energy, and which has no torque */
    std::optional<OperatingPoint> add_step(const double length, ContactFields &fields);
    /** The next state. @throws ComputationError if none is found: when, at which load */
    OperatingState step(const RotorLoad &now, const double length);

    const RotorLoad load;
    const unsigned int n_parts;  ///< of a step
    const unsigned int n_joined; ///< steps
    MarchingDriver driver;
    OperatingState last;
    std::optional<NodePass> pass; ///< until the last step
    CurvePoint taken;
  };

  /**
   * Finds an operating point by marching. Averages over whole periods of the solution once their
   * means have settled to a tenth of `Accuracy/Contact target`, the steps being shortened so that a
   * period is a whole number of them; the fields are those of the last period. If `Time` specifies
   * steps to average over, the point has their means and the fields of all requested steps.
   * @p n_joined of these steps are joined into one, as far as the window allows.
   *
   * @throws ComputationError if a step fails or the means do not settle
   */
  CurvePoint find_marched(const Parameters &parameters, const MotorInUse &motor,
                          const PointRequest &request, const unsigned int n_joined = 1);
} // namespace ringmotor
