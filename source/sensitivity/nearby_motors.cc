// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/relevant.h>
#include <ringmotor/motor/rotor_loss.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/point_finder.h>
#include <ringmotor/sensitivity/nearby_motors.h>

namespace ringmotor
{
  namespace
  {
    /** Points of other motors start from those of the first one, not from their neighbours. */
    const Variation other_motor{"other motor"};

    /** Whether two motors have in common what a selection of their entries says. */
    bool have_same(Parameters (*const selected)(const Parameters &), const Parameters &one,
                   const Parameters &other)
    {
      return text_of(selected(one)) == text_of(selected(other));
    }

    Parameters relevant_points(const Parameters &parameters)
    {
      return relevant_for_points(parameters);
    }

    Parameters with_amplitude(Parameters parameters, const double amplitude)
    {
      parameters.wave.amplitude = amplitude;
      return parameters;
    }
  } // namespace

  const std::vector<SensitiveQuantity> &sensitive_quantities()
  {
    static const std::vector<SensitiveQuantity> quantities{
        {"frequency", units::hertz},
        {"no_load_speed", units::speed},
        {"stall_torque", units::torque},
        {"half_load_speed", units::speed},
        {"half_load_friction_loss", units::power},
        {"half_load_efficiency", units::one}};
    return quantities;
  }

  NearbyMotors::NearbyMotors(const NearbyStators &stators, const Discretisation &discretisation)
      : stators(stators), discretisation(discretisation),
        motor(condensed(parameters(), stators.stator())), points(points_of_first()),
        first_values(values_of(parameters(), stators.stator(), points))
  {
  }

  std::unique_ptr<const CondensedMotor> NearbyMotors::condensed(const Parameters &other,
                                                                const StatorOnMesh &on) const
  {
    return std::make_unique<const CondensedMotor>(
        condense_motor(other, on.wave, ContactDiscretisation::level(discretisation.level),
                       discretisation.modes_level, nullptr, ModeSets::own));
  }

  NearbyMotors::Points NearbyMotors::points_of_first() const
  {
    // Who sticks may depend on the start: all motors begin with the same state.
    const Points from_rest = points_of(parameters(), stators.stator(), *motor, nullptr);
    return points_of(parameters(), stators.stator(), *motor, &from_rest);
  }

  NearbyMotors::Points NearbyMotors::points_of(const Parameters &other, const StatorOnMesh &on,
                                               const CondensedMotor &its,
                                               const Points *starts) const
  {
    MotorInUse in_use = its;
    in_use.wave       = its.wave.at(on.wave.amplitude, on.wave.angular_frequency);
    OperatingPointFinder finder(
        with_parts_of_a_step(other, discretisation.steps.n_parts), in_use,
        starts == nullptr ? discretisation : discretisation.with(other_motor), on.wave.drive);
    const auto find = [&](const Control control, const double value, CurvePoint Points::*const at) {
      return finder.find({control, value}, starts == nullptr ? nullptr : &(starts->*at));
    };
    Points found;
    found.stalled = find(Control::speed, 0., &Points::stalled);
    found.half_loaded =
        find(Control::torque, 0.5 * found.stalled.result.torque, &Points::half_loaded);
    found.without_load = find(Control::torque, 0., &Points::without_load);
    return found;
  }

  std::vector<double> NearbyMotors::values_of(const Parameters &other, const StatorOnMesh &on,
                                              const Points &of) const
  {
    const OperatingPoint &half = of.half_loaded.result;
    const LossBudget budget    = loss_budget(of.half_loaded, on.energies_on(other), other.materials,
                                             rotor_loss_by_part(other), other.support);
    return {on.natural_frequency, of.without_load.result.speed, of.stalled.result.torque,
            half.speed,           half.friction_loss(),         budget.efficiency().value};
  }

  std::vector<double> NearbyMotors::values_of(const Parameters &other) const
  {
    const Parameters &first = parameters();
    const StatorOnMesh its  = stators.of(other);
    const bool same_wave =
                   have_same(relevant_for_wave, first, with_amplitude(other, first.wave.amplitude)),
               same_bodies = same_wave && have_same(relevant_for_condensation, first,
                                                    with_amplitude(other, first.wave.amplitude)),
               same_points = same_bodies && have_same(relevant_points, first, other);
    if (same_points)
      return values_of(other, its, points);
    std::unique_ptr<const CondensedMotor> condensed_again;
    if (!same_bodies)
      condensed_again = condensed(other, its);
    const CondensedMotor &its_motor = same_bodies ? *motor : *condensed_again;
    if (its_motor.n_dofs != motor->n_dofs || its_motor.nodes.size() != motor->nodes.size())
      throw ComputationError("the meshes of the bodies in contact get other cells");
    return values_of(other, its, points_of(other, its, its_motor, &points));
  }
} // namespace ringmotor
