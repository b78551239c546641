// SPDX-License-Identifier: LGPL-2.1-or-later

// The size of effects, as measured at operating points with and without them.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/motor/effect.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/points/effect_on_points.h>
#include <ringmotor/points/point_finder.h>
#include <ringmotor/points/point_quantities.h>

#include <gtest/gtest.h>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  /** Expects the size of an effect to be the same after another one, from whose points it starts.
   */
  void expect_same_after_another(const Parameters &parameters)
  {
    const StatorWave wave = stator_wave(parameters);
    const MotorVibration vibration(parameters, wave);
    EffectsOnPoints together(wave, vibration, MPI_COMM_SELF), alone(wave, vibration, MPI_COMM_SELF);
    together.of(effect("Tooth shear"), parameters);
    const EffectOnPoints second = together.of(effect("Tooth inertia"), parameters),
                         first  = alone.of(effect("Tooth inertia"), parameters);
    for (const PointQuantity &quantity : point_quantities())
      EXPECT_NEAR(second.largest()[quantity.name], first.largest()[quantity.name],
                  1e-6 * first.largest()[quantity.name])
          << quantity.name;
    EXPECT_NEAR(second.relative, first.relative, 1e-6 * first.relative);
  }
} // namespace

TEST(EffectsOnPoints, AreTheSameWhereAnotherEffectWasMeasuredBefore)
{
  // They share the motor without either.
  expect_same_after_another(reference_motor());
}

TEST(EffectsOnPointsLong, AreTheSameWhereAnotherEffectWasMeasuredBefore)
{
  // With inertia a search from rest and one from a similar motor take different ways.
  Parameters parameters               = reference_motor();
  parameters.effects["Rotor inertia"] = EffectChoice::on;
  parameters.effects["Damping"]       = EffectChoice::on;
  expect_same_after_another(parameters);
}

TEST(EffectsOnPoints, OfFrictionThatFallsAreThoseOfTheDynamicCoefficient)
{
  Parameters parameters   = reference_motor();
  const StatorWave wave   = stator_wave(parameters);
  parameters.friction.law = FrictionLaw("coulomb");
  const auto change       = [&]
  {
    return EffectsOnPoints(wave, MotorVibration(parameters, wave), MPI_COMM_SELF)
        .of(effect("Tooth inertia"), parameters)
        .relative;
  };
  const double of_constant               = change();
  parameters.friction.law                = FrictionLaw("slip-weakening");
  parameters.friction.static_coefficient = 1.4 * parameters.friction.dynamic_coefficient;
  EXPECT_NEAR(change(), of_constant, 1e-6 * of_constant);
}

TEST(EffectsOnPoints, OfAStaticExcessAreThoseOfItsCoefficientWhereItNeverDecays)
{
  Parameters parameters                  = reference_motor();
  const StatorWave wave                  = stator_wave(parameters);
  parameters.friction.law                = FrictionLaw("velocity");
  parameters.friction.decay_velocity     = 1e6; // m/s
  parameters.friction.static_coefficient = 1.1 * parameters.friction.dynamic_coefficient;
  const EffectOnPoints of_excess =
      EffectsOnPoints(wave, MotorVibration(parameters, wave), MPI_COMM_SELF)
          .of(effect("Static friction excess"), parameters);
  const auto points_with = [&](const double coefficient, const std::vector<PointRequest> &requests)
  {
    Parameters constant                  = parameters;
    constant.friction.law                = FrictionLaw("coulomb");
    constant.friction.static_coefficient = constant.friction.dynamic_coefficient = coefficient;
    const CondensedMotor motor = condense_motor(constant, wave, ContactDiscretisation::level(0));
    OperatingPointFinder finder(constant, motor);
    std::vector<CurvePoint> points;
    for (const PointRequest &request : requests)
      points.push_back(finder.find(request));
    return points;
  };
  const auto &[of_static, of_dynamic] =
      std::pair(parameters.friction.static_coefficient, parameters.friction.dynamic_coefficient);
  const PointRequest stall{Control::speed, 0.};
  const double torque = points_with(of_dynamic, {stall}).front().result.torque;
  EXPECT_NEAR(of_excess.stall_torque, torque, 1e-9 * torque);
  const std::vector<PointRequest> requests{
      {Control::torque, 0.}, {Control::torque, 0.5 * torque}, {Control::torque, 0.85 * torque}};
  const std::vector<CurvePoint> with    = points_with(of_static, requests),
                                without = points_with(of_dynamic, requests);
  for (const auto &[load, i] : {std::pair(0., 0u), std::pair(0.5, 1u), std::pair(0.85, 2u)})
  {
    const double expected = std::abs(with[i].result.speed - without[i].result.speed);
    EXPECT_NEAR(of_excess.changes.at(load)["speed"], expected, 1e-6 * expected) << load;
  }
  const double at_stall = points_with(of_static, {stall}).front().result.torque - torque;
  record("change of the stall torque, relative", at_stall / torque);
  EXPECT_GT(at_stall, 0.05 * torque);
  EXPECT_NEAR(of_excess.at(torque)["torque"], at_stall, 1e-6 * at_stall);
}

TEST(EffectsOnPoints, OfAJumpFromStaticToDynamicFrictionAreSmall)
{
  // It has no fracture energy: what it changes vanishes with the step and the mesh.
  Parameters parameters                  = reference_motor();
  const StatorWave wave                  = stator_wave(parameters);
  parameters.friction.law                = FrictionLaw("static-dynamic");
  parameters.friction.static_coefficient = 1.2 * parameters.friction.dynamic_coefficient;
  const double relative = EffectsOnPoints(wave, MotorVibration(parameters, wave), MPI_COMM_SELF)
                              .of(effect("Static friction excess"), parameters)
                              .relative;
  record("relative change", relative);
  EXPECT_GT(relative, 0.);
  EXPECT_LT(relative, 0.01);
}
