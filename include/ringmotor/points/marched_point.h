// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/marching.h>
#include <ringmotor/points/curve_point.h>

#include <optional>

namespace ringmotor
{
  /** Some equal steps of a marched motor. */
  struct MarchedSpan
  {
    OperatingPoint mean;  ///< over its steps, except the very first one of a run
    ContactFields fields; ///< at the ends of all parts of its steps
    bool repeats = false; ///< at its end the motion is the same as before, throughout the span
  };

  /** A motor marched through time under one load, whose torque starts after the first part-step. */
  class MarchedRun
  {
  public:
    /** The bodies of @p motor must outlive this object and all that it returns. @param start the
     * state of a similar motor to continue from, instead of one at rest */
    MarchedRun(const Parameters &parameters, const MotorInUse &motor, const PointRequest &request,
               const unsigned int n_joined = 1, const MarchedState *start = nullptr);

    /** Advances by some steps of a length (s). As many of these as possible are joined into one,
     * which is divided into `Time/Snapshots` parts. @throws ComputationError */
    MarchedSpan advance(const unsigned int n_steps, const double length);

    /** See MarchingDriver::damp(). */
    void damp(const double loss_factor) { driver.damp(loss_factor); }

    MarchedState state() const { return driver.state(); }
    const bool begins_from_rest; ///< and without a torque

    /** The certificate of all steps so far, and the effort to find them. */
    const CurvePoint &effort() const { return taken; }

  private:
    /** The steps of a span, except the very first one of a run, before which there is no energy. */
    struct Evaluated
    {
      std::vector<OperatingPoint> results;
      std::vector<double> lengths; ///< s
    };
    /** Advances by a part of a step, or by halves of it if no state is found at its end and it may
     * be halved so often. @throws ComputationError */
    void add_step(const double length, Evaluated &evaluated, const unsigned int n_halvings);
    /** The next state. @throws ComputationError if none is found: when, at which load */
    OperatingState step(const double length, const Fallback fallback);

    const RotorLoad load;
    const unsigned int n_parts;       ///< of a step
    const unsigned int n_joined;      ///< steps
    const unsigned int most_halvings; ///< of a step; none where `Time` counts the steps
    MarchingDriver driver;
    OperatingState last;
    std::optional<NodePass> pass; ///< until the last step
    CurvePoint taken;
  };

  /**
   * Finds an operating point by marching. Averages over whole periods of the solution once their
   * means are known to a tenth of `Accuracy/Contact target`, see SpanMeans, the steps being
   * shortened so that a period is a whole number of them; the fields are those of the last period.
   * If `Time` specifies steps to average over, the point has their means and the fields of all
   * requested steps.
   * @p n_joined of these steps are joined into one, as far as the window allows.
   *
   * @throws ComputationError if a step fails or the means do not settle
   */
  CurvePoint find_marched(const Parameters &parameters, const MotorInUse &motor,
                          const PointRequest &request, const unsigned int n_joined = 1,
                          const CurvePoint *start = nullptr);
} // namespace ringmotor
