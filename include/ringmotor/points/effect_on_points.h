// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/effect.h>
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/points/curve_point.h>

#include <map>

namespace ringmotor
{
  /** The approximate influence of an effect on a motor. */
  struct EffectOnPoints
  {
    /** The largest of the changes at no load, at half the stall torque and at stall. */
    PointError change;
    double relative = 0.; ///< of speed and torque, relative to no load and stall
  };

  /**
   * Compares operating points of a uniform ring with and without an effect on the coarsest mesh,
   * with few modes. EffectOnPoints::relative is infinite if there is a state without the effect,
   * but none with it.
   * @param vibration of the rotor of that ring
   * @param communicator of the ranks that share the work. Collective
   * @throws ComputationError if no state is found without the effect
   */
  EffectOnPoints effect_on_points(const Parameters &parameters, const Effect &effect,
                                  const StatorWave &wave, const MotorVibration &vibration,
                                  MPI_Comm communicator);

  /** The effects that `auto` has left out of a motor. */
  class LeftOut
  {
  public:
    LeftOut() = default;
    /** @param measured effects whose indicator comes from operating points, by name */
    LeftOut(const std::vector<EffectRow> &rows,
            const std::map<std::string, EffectOnPoints> &measured);

    /** The error of a point that may result. */
    PointError of(const CurvePoint &point) const;

  private:
    double relative = 0.; ///< of effects that change all results alike
    PointError others;
  };
} // namespace ringmotor
