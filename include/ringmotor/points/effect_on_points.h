// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/effect.h>
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/points/curve_point.h>
#include <ringmotor/points/quantity_scales.h>

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ringmotor
{
  /** The approximate influence of an effect on a motor. */
  struct EffectOnPoints
  {
    /** By what it changes operating points, by their loads as shares of the stall torque. */
    std::map<double, PointError> changes;
    double stall_torque = 0.; ///< N m, without it
    /** Of speed and torque, with respect to QuantityScales. */
    double relative = std::numeric_limits<double>::infinity();

    /** The change of an operating point at a load (N m): the larger one of the loads on both sides,
     * as small changes at a single load may be by chance. */
    PointError at(const double torque) const;
    /** The largest of all of them. */
    PointError largest() const;
    /** Sets #relative. @param fastest rad/s, the speed without load */
    void relate_to(const QuantityScales &scales, const double fastest);
  };

  /**
   * Compares operating points of a uniform ring with and without an effect on the coarsest mesh,
   * with few modes. Motors that several effects are compared with are computed once.
   */
  class EffectsOnPoints
  {
  public:
    /** @param wave and
     *  @param vibration of the rotor of that ring have to outlive this object
     *  @param communicator of the ranks that share the work */
    EffectsOnPoints(const StatorWave &wave, const MotorVibration &vibration, MPI_Comm communicator);
    ~EffectsOnPoints();

    /** Compares the motor with an effect with the one without it. EffectOnPoints::relative is
     * infinite if there is no state with it or, of a marched motor, without it. Collective.
     * @throws ComputationError if there is one, but none is found without the effect */
    EffectOnPoints of(const Effect &effect, const Parameters &parameters);

  private:
    struct Motor;
    struct Wanted;

    /** The motors with these parameters, new ones condensed by ranks that share them. */
    std::vector<Motor *> condensed(const std::vector<Parameters> &all);
    /** The point at the same load of another motor that has inertia as well, or neither has;
     * nullptr if none is known. */
    const CurvePoint *known_to_similar(const Wanted &wanted) const;
    /** Points of motors, new ones found by ranks that share them: empty if there is none. */
    std::vector<std::vector<CurvePoint>> found(const std::vector<Wanted> &all);
    /** Those of one motor; none if one of them is missing. @param start of all of them */
    std::vector<CurvePoint> all_found(Motor &of, const std::vector<PointRequest> &requests,
                                      const CurvePoint *start, const bool are_needed);

    const StatorWave &wave;
    const MotorVibration &vibration;
    const MPI_Comm communicator;
    std::map<std::string, std::unique_ptr<Motor>> motors; ///< by what their points depend on
  };

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
    std::vector<EffectOnPoints> others;
  };
} // namespace ringmotor
