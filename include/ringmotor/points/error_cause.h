// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/motor_model.h>
#include <ringmotor/parameters/part_list.h>
#include <ringmotor/points/cures.h>
#include <ringmotor/points/effect_on_points.h>
#include <ringmotor/points/point_table.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** What causes of errors see of a search: how far it has come, and the points in all
   * discretisations. */
  struct ErrorScene
  {
    const Parameters &parameters;
    const LeftOut &left_out; ///< effects
    const StepChoice &steps;
    PointTable &table;
    unsigned int level, modes_level; ///< reached
    bool has_inertia;

    /** The mesh compared with that of a level to estimate the error of meshes. */
    static unsigned int compared_with(const unsigned int level)
    {
      return level == 0 ? 1 : level - 1;
    }
    /** With the steps with which meshes are compared, on the meshes of a level. */
    Discretisation plain(const unsigned int of_level) const
    {
      return {of_level, modes_level, steps.of_meshes()};
    }
    Discretisation plain() const { return plain(level); }
    /** That in which motors are varied: what this changes depends little on the mesh. On the last
     * mesh but one, from mesh 2 on; of a marched motor, whose points are dear, from mesh 1 on. */
    Discretisation for_variations() const
    {
      return plain(level > (is_marched(parameters) ? 0 : 1) ? compared_with(level) : level)
          .with(steps.plain());
    }
    const CondensedMotor &motor() const { return table.motor(level, modes_level); }
    /** The speed (rad/s) of the crests of the wave at a point. */
    double crest_speed(const CurvePoint &point) const
    {
      return motor().crest_speed() * (point.result.amplitude / motor().wave.amplitude);
    }
    /** By how much a variation of the motor changes a point. */
    PointError change_by(const Variation &variation, const PointRequest &request) const;
  };

  /**
   * A cause of errors of operating points: what has to be computed to know them, how large they
   * are, and what makes them smaller. There is one class for each in points/causes;
   * all_error_causes() is the list.
   */
  class ErrorCause
  {
  public:
    /** @param name in all outputs */
    ErrorCause(const std::string &name, const std::optional<Cure> cure = {})
        : name(name), cure(cure)
    {
    }
    virtual ~ErrorCause() = default;

    /** Discretisations in which all measured points are needed beside their own ones; none if the
     * motor has no such errors. */
    virtual std::vector<Discretisation> needs(const ErrorScene &) const { return {}; }

    /** The same of points alone whose own discretisation is @p own. */
    virtual std::vector<Discretisation> needs_beside(const Discretisation & /*own*/,
                                                     const ErrorScene &) const
    {
      return {};
    }

    /** Whether the errors of a point whose own discretisation is @p own are found by comparison
     * with other ones. */
    bool compares(const Discretisation &own, const ErrorScene &scene) const
    {
      return !needs(scene).empty() || !needs_beside(own, scene).empty();
    }

    /** The error of a point, each number not negative; empty if the motor has none. @param own the
     * discretisation of the point */
    virtual PointError of(const PointRequest &request, const Discretisation &own,
                          const ErrorScene &scene) const = 0;

    /** What a point tells of its error without comparison: its error is at least this. */
    virtual PointError least_of(const CurvePoint & /*point*/, const ErrorScene &) const
    {
      return {};
    }

    /** What a user can do where this cause alone is too large and nothing else helps, as the end of
     * a sentence from its punctuation on; empty: no more than about any other error. */
    virtual std::string remedy(const Parameters &) const { return {}; }

    const std::string name;
    const std::optional<Cure> cure;
  };

  /** All of them. */
  const PartList<ErrorCause> &all_error_causes();

  /** The friction loss that an error of speed and torque brings with it, in W: a wave gives about
   * the same power to a motor on other meshes or with other modes, and what less speed or torque
   * leaves of it is lost in friction. */
  PointError least_of_power(const CurvePoint &point, const PointError &error);

  /** Given shares of the speed of the crests (rad/s), if a torque is given, and of the loss. */
  PointError shares_of(const CurvePoint &point, const double crest_speed, const double of_speed,
                       const double of_loss);
} // namespace ringmotor
