// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/causes/list.h>
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  namespace
  {
    /** With what steps of a point are compared. */
    Steps compared_steps(const Steps &own, const Steps &plain)
    {
      return own == plain ? plain.to_compare_with() : plain;
    }

    /** How finely numbers that are counted are resolved: a tooth touches for whole steps, and a
     * contact node sticks or slips as a whole. Two discretisations often count the same. */
    PointError resolution(const CurvePoint &point, const CondensedMotor &motor)
    {
      PointError step;
      step["teeth_in_contact_per_wave"] = static_cast<double>(motor.n_teeth) / motor.n_waves *
                                          point.fields.time_step / motor.period();
      for (const char *const fraction : {"stick_fraction", "second_stick_fraction"})
        step[fraction] = point.largest_share;
      return step;
    }

    /** A point on the mesh on which steps are compared: its own one or, of a marched motor, the one
     * for variations. */
    Discretisation on_mesh_of_comparison(Discretisation own, const ErrorScene &scene)
    {
      if (is_marched(scene.parameters))
        own.level = scene.for_variations().level;
      return own;
    }

    /** The time step, of first order: from the change from a longer or a shorter one. */
    class ErrorOfTimeStep : public ErrorCause
    {
    public:
      ErrorOfTimeStep() : ErrorCause(causes::time_step, Cure::steps) {}

      std::vector<Discretisation> needs_beside(const Discretisation &own,
                                               const ErrorScene &scene) const override
      {
        const Discretisation compared = on_mesh_of_comparison(own, scene);
        return {compared, compared.with(compared_steps(own.steps, scene.steps.plain()))};
      }

      PointError of(const PointRequest &request, const Discretisation &own,
                    const ErrorScene &scene) const override
      {
        const std::vector<Discretisation> both = needs_beside(own, scene);
        const CurvePoint &point                = scene.table.at(own, request),
                         &with_own_steps       = scene.table.at(both.front(), request),
                         &with_others          = scene.table.at(both.back(), request);
        // C / n with n steps per pitch: C follows from two values of n.
        const double n = own.steps.number(), of_other = both.back().steps.number();
        PointError error = of_other / std::abs(of_other - n) * change(with_own_steps, with_others);
        return error.raise(least_of(point, scene));
      }

      PointError least_of(const CurvePoint &point, const ErrorScene &scene) const override
      {
        PointError least       = resolution(point, scene.motor());
        least["friction_loss"] = std::abs(point.result.missing_power());
        return least;
      }
    };
  } // namespace

  std::unique_ptr<const ErrorCause> causes::of_time_step()
  {
    return std::make_unique<const ErrorOfTimeStep>();
  }
} // namespace ringmotor
