// SPDX-License-Identifier: LGPL-2.1-or-later
// A motor reduced to a brush model: rigid bodies, a lining with normal compliance only, and a wave
// without radial motion. Expected: closed form of a rigid sine on a Winkler foundation with Coulomb
// friction and no tangential compliance (n 7, R 35.25 mm, A 2 um, A_t 1.44 um, 30 kHz, 14 N, mu
// 0.40, 5.5e8 N/m per metre of circumference).

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/points/point_finder.h>

#include <gtest/gtest.h>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double radius = 35.25e-3, rpm = M_PI / 30.;

  Parameters rigid_motor()
  {
    Parameters parameters                           = reference_motor();
    parameters.materials.rotor_metal.young_modulus  = 1e20;
    parameters.materials.stator_metal.young_modulus = 1e20;
    parameters.rotor.radial_bar_stiffness           = 1e18;
    parameters.effects["Friction lining"]           = EffectChoice::on;
    parameters.friction.lining_normal_stiffness     = 1.; // see winkler()
    parameters.friction.lining_tangential_stiffness = 1.;
    return parameters;
  }

  /**
   * The wave of the brush model at the contact nodes, all of which lie at its radius, and its
   * foundation as the lining; the small tangential compliance is reversed at each change of
   * direction, 1 % of the friction loss with this stiffness.
   */
  CondensedMotor brush_model(Parameters &parameters)
  {
    StatorWave wave;
    wave.n_waves           = 7;
    wave.angular_frequency = 2. * M_PI * 30e3;
    wave.amplitude         = 2e-6;
    wave.foot = wave.top = [](const dealii::Point<3> &) {
      return std::array<std::complex<double>, 3>{{0., 1e-6, 1e-6}};
    };
    const ContactDiscretisation mesh = ContactDiscretisation::level(0);
    double area                      = 0.;
    for (const CondensedMotor::Node &node : condense_motor(parameters, wave, mesh).nodes)
      area += 90. * node.area;
    parameters.friction.lining_normal_stiffness = 5.5e8 * 2. * M_PI * radius / area;
    parameters.friction.lining_tangential_stiffness =
        1000. * *parameters.friction.lining_normal_stiffness;
    CondensedMotor motor = condense_motor(parameters, wave, mesh);
    motor.wave.free_motion.clear();
    for (CondensedMotor::Node &node : motor.nodes)
    {
      const std::complex<double> phase = std::polar(1., -7. * node.angle), i(0., 1.);
      node.radius                      = radius;
      motor.wave.free_motion.push_back({{2e-6 * phase, -i * 1.44e-6 * phase, 0.}});
    }
    return motor;
  }
} // namespace

TEST(BrushModel, SpeedAndFrictionLoss)
{
  Parameters parameters      = rigid_motor();
  const CondensedMotor motor = brush_model(parameters);
  struct
  {
    double torque, speed, loss; // mN m, rpm, mW
  } const expected[] = {
      {0., 70.529, 81.82}, {50., 68.556, 87.28}, {100., 65.746, 109.80}, {150., 61.422, 167.37}};
  const Parameters divided = with_parts_of_a_step(parameters, 2);
  OperatingPointFinder finder(divided, motor);
  for (const auto &point : expected)
  {
    const OperatingPoint found = finder.find({Control::torque, 1e-3 * point.torque}).result;
    record("speed at 0, 50, 100, 150 mN m (rpm)", found.speed / rpm);
    record("friction loss at 0, 50, 100, 150 mN m (mW)", 1e3 * found.friction_loss());
    EXPECT_NEAR(found.speed / rpm, point.speed, 0.005 * point.speed) << point.torque;
    EXPECT_NEAR(1e3 * found.friction_loss(), point.loss, 0.02 * point.loss) << point.torque;
    EXPECT_LT(found.radial_loss, 1e-9 * found.friction_loss());
  }
}
