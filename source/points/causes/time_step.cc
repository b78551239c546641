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
      if (!(own == plain))
        return plain;
      // Longer steps are cheap, but where a step is undivided they may miss the contact of a tooth.
      return plain.n_parts % 2 == 0 ? plain.doubled() : plain.halved();
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

    /** The time step, of first order: from the change from a longer or a shorter one on the mesh in
     * use. */
    class ErrorOfTimeStep : public ErrorCause
    {
    public:
      ErrorOfTimeStep() : ErrorCause(causes::time_step, Cure::steps) {}

      std::vector<Discretisation> needs_beside(const Discretisation &own,
                                               const ErrorScene &scene) const override
      {
        return {own.with(compared_steps(own.steps, scene.steps.plain()))};
      }

      PointError of(const PointRequest &request, const Discretisation &own,
                    const ErrorScene &scene) const override
      {
        const Discretisation other = needs_beside(own, scene).front();
        const CurvePoint &point    = scene.table.at(own, request);
        // C / n with n steps per pitch: C follows from two values of n.
        const double n = own.steps.number(), of_other = other.steps.number();
        PointError error =
            of_other / std::abs(of_other - n) * change(point, scene.table.at(other, request));
        error.raise(resolution(point, scene.motor()));
        PointError missing;
        missing["friction_loss"] = std::abs(point.result.missing_power());
        return error.raise(missing);
      }
    };
  } // namespace

  std::unique_ptr<const ErrorCause> causes::of_time_step()
  {
    return std::make_unique<const ErrorOfTimeStep>();
  }
} // namespace ringmotor
