// SPDX-License-Identifier: LGPL-2.1-or-later

// The size of effects, as measured at operating points with and without them.

#include "support/motor_model.h"

#include <ringmotor/motor/effect.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/points/effect_on_points.h>
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
      EXPECT_NEAR(second.change[quantity.name], first.change[quantity.name],
                  1e-6 * first.change[quantity.name])
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
