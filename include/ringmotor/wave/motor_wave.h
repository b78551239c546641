// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/modes.h>
#include <ringmotor/results/quantity.h>
#include <ringmotor/wave/energy.h>
#include <ringmotor/wave/mode_search.h>
#include <ringmotor/wave/tooth_motion.h>

#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** The motion of a named point of the tooth. */
  struct PointResult
  {
    ToothPoint point;
    EllipticMotion motion;
  };

  /** Position at rest, amplitudes and phases of a tooth point: the columns of `ellipses.csv`. */
  std::vector<Quantity> quantities_of(const PointResult &result);

  /** The motor's travelling wave at its amplitude: what the contact needs of the stator. */
  struct WaveResult
  {
    FoundMode found;                 ///< scaled to the wave's amplitude
    double angular_frequency = 0.;   ///< rad/s, of the forced motion
    double amplitude         = 0.;   ///< m, normal, at the outer edge of the tooth top
    std::vector<PointResult> points; ///< the 18 named points
    WaveEnergy energy;
    double modal_mass = 0.; ///< kg
    double gap_below  = 0.; ///< relative distance of the next slower mode of the same nodal
                            ///< diameter; 0: none computed
    double gap_above = 0.;  ///< the same for the next faster one

    /** Quantities of the wave's shape; empty after the first mesh, which gives no error. */
    std::vector<Quantity> shape;

    /** Relative error of the speed of the tooth tops along the ring, which drives the rotor: that
     * of the frequency plus that of A_t/A_n. Infinite without #shape. */
    double relative_error() const;
  };

  /**
   * Follows the motor's wave from pass to pass of a ModeSearch of the stator: the error bars of its
   * shape are estimated from its change from one mesh to the next.
   */
  class MotorWave
  {
  public:
    MotorWave(const unsigned int n_waves, const Wave &request);

    /** Adds the result of the last compute() of @p search. */
    void add_pass(const ModeSearch &search);

    /** The wave of the last pass; null if it is not among the modes, or without teeth. Its
     * displacements are invalid after the next refinement. */
    const WaveResult *result() const { return wave ? &*wave : nullptr; }

  private:
    /** The quantities of the shape in one pass, without errors. */
    struct Sample
    {
      std::vector<Quantity> shape;
      FrequencySample frequency;
    };

    WaveResult make_result(const ModeSearch &search, const FoundMode &working,
                           const std::vector<ToothPoint> &points) const;

    const unsigned int n_waves;
    const Wave request;
    std::optional<WaveResult> wave;
    std::optional<Sample> earlier; ///< of the last pass that had the wave
  };
} // namespace ringmotor
