// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/effect.h>
#include <ringmotor/quantities/torque_speed.h>

#include <map>

namespace ringmotor
{
  /** What an effect does to a motor, at least approximately. */
  struct EffectOnPoints
  {
    double speed    = 0.; ///< rad/s, the larger change, without load and at half the stall torque
    double torque   = 0.; ///< N m, change at stall; where speeds are given, also at half of it
    double loss     = 0.; ///< relative change of the friction loss, the larger one of both
    double relative = 0.; ///< the largest of speed and torque, by those at no load and at stall
  };

  /**
   * Compares operating points of a uniform ring with and without an effect on the coarsest mesh,
   * with few modes. Infinite if there is a state without it, but none with it.
   * @throws ComputationError if none is found without it
   */
  EffectOnPoints effect_on_points(const Parameters &parameters, const Effect &effect,
                                  const StatorWave &wave);

  /** What `auto` has left out of a motor. */
  class LeftOut
  {
  public:
    LeftOut() = default;
    /** @param measured those whose indicator comes from operating points, by name */
    LeftOut(const std::vector<EffectRow> &rows,
            const std::map<std::string, EffectOnPoints> &measured);

    /** What that may cost a point. */
    PointError of(const CurvePoint &point) const;

  private:
    double relative = 0.; ///< of effects that change all results alike
    EffectOnPoints others;
  };
} // namespace ringmotor
