// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/modes.h>
#include <ringmotor/quantities/energy.h>
#include <ringmotor/quantities/mode_search.h>
#include <ringmotor/quantities/tooth_motion.h>

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

  /** The motor's travelling wave at its amplitude: what the contact needs to know of the stator. */
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

    /** A number that the wave's shape gives. */
    struct ShapeNumber
    {
      std::string name, unit;
      Estimate estimate;
    };
    std::vector<ShapeNumber> shape; ///< empty after the first mesh, which tells no error

    /** Relative error of the speed of the tooth tops along the ring, which is what drives the
     * rotor: that of the frequency and that of A_t/A_n. Infinite without #shape. */
    double relative_error() const;
  };

  /**
   * Follows the motor's wave from pass to pass of a ModeSearch of the stator: the change of its
   * shape from one mesh to the next is what the error bars of the shape are made from.
   */
  class MotorWave
  {
  public:
    MotorWave(const unsigned int n_waves, const Wave &request);

    /** Takes over what the last compute() of @p search has found. */
    void add_pass(const ModeSearch &search);

    /** The wave of the last pass; null if it is not among the modes. Its displacements are void
     * after the next refinement. */
    const WaveResult *result() const { return wave ? &*wave : nullptr; }

  private:
    /** The shape's numbers in one pass; names and units without an error bar. */
    struct Sample
    {
      std::vector<WaveResult::ShapeNumber> shape;
      FrequencySample frequency;
    };

    WaveResult make_result(const ModeSearch &search, const FoundMode &working) const;

    const unsigned int n_waves;
    const Wave request;
    std::optional<WaveResult> wave;
    std::optional<Sample> earlier; ///< of the last pass that had the wave
  };
} // namespace ringmotor
