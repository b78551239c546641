// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/effect.h>
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/quantities/torque_speed.h>

#include <map>

namespace ringmotor
{
  /** What an effect does to a motor, at least approximately. */
  struct EffectOnPoints
  {
    /** The largest change without load, at half the stall torque and at stall. */
    PointError change;
    double relative = 0.; ///< of speed and torque, by those at no load and at stall
  };

  /**
   * Compares operating points of a uniform ring with and without an effect on the coarsest mesh,
   * with few modes. @param vibration of the rotor of that ring. Infinite if there is a state
   * without it, but none with it.
   * @throws ComputationError if none is found without it
   */
  EffectOnPoints effect_on_points(const Parameters &parameters, const Effect &effect,
                                  const StatorWave &wave, const RotorVibration &vibration);

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
    PointError others;
  };
} // namespace ringmotor
