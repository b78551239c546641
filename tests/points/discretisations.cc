// SPDX-License-Identifier: LGPL-2.1-or-later

// The sequence of discretisations of the contact: each divides the errors of the one before, which
// the error bars rely on, and each has more unknowns.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/points/point_finder.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double rpm = M_PI / 30.;

  struct Found
  {
    std::array<double, 2> speed, loss; ///< rpm, mW, at 50 and 100 mN m
    unsigned int n_dofs;
  };

  Found find(const Parameters &parameters, const StatorWave &wave, const unsigned int level)
  {
    constexpr unsigned int n_parts = 4; // errors of the step are far below those of the meshes
    const CondensedMotor motor =
        condense_motor(parameters, wave, ContactDiscretisation::level(level));
    OperatingPointFinder finder(with_parts_of_a_step(parameters, n_parts), motor);
    Found found{{}, {}, motor.n_dofs};
    for (unsigned int i = 0; i < 2; ++i)
    {
      const CurvePoint point = finder.find({Control::torque, 0.05 * (i + 1)});
      found.speed[i]         = point.result.speed / rpm;
      found.loss[i]          = 1e3 * point.result.friction_loss();
      record("speed at 50, 100 mN m (rpm), interface mesh " + std::to_string(level),
             found.speed[i]);
      record("friction loss at 50, 100 mN m (mW), interface mesh " + std::to_string(level),
             found.loss[i]);
    }
    return found;
  }
} // namespace

TEST(DiscretisationsLong, DivideTheErrorsOfTheOnesBefore)
{
  Parameters parameters           = reference_motor();
  parameters.rotor.flange_element = ElementKind::shell; // cheaper on the finest
  const StatorWave wave           = stator_wave(parameters);
  std::array<Found, 4> on;
  for (unsigned int level = 0; level < on.size(); ++level)
    on[level] = find(parameters, wave, level);
  for (unsigned int level = 1; level < on.size(); ++level)
    EXPECT_GT(on[level].n_dofs, on[level - 1].n_dofs) << level;
  for (unsigned int i = 0; i < 2; ++i)
  {
    const auto distance =
        [&](const std::array<double, 2> Found::*const quantity, const unsigned int level)
    { return std::abs((on[level].*quantity)[i] - (on[3].*quantity)[i]); };
    EXPECT_LT(2. * distance(&Found::speed, 2), distance(&Found::speed, 1)) << i;
    EXPECT_LT(distance(&Found::speed, 1), distance(&Found::speed, 0)) << i;
    // Better than the target of 1 % that is usually met with discretisation 2.
    EXPECT_LT(distance(&Found::speed, 2), 2e-3 * on[3].speed[i]) << i;
    EXPECT_LT(distance(&Found::loss, 2), 1e-2 * on[3].loss[i]) << i;
  }
}
