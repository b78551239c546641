// SPDX-License-Identifier: LGPL-2.1-or-later

// Friction laws in both drivers, on a ring without a wave: twenty teeth, each pressed with N = 5 N,
// on springs of c = 1e-7 m/N along the ring; mu_s = 0.5, mu_d = 0.3. The rotor is turned by given
// distances. For each distance d, friction on a sticking tooth increases by d/c; on one that slips
// by s it is mu N = F + (d - s)/c, a linear equation where mu falls linearly with s. In the steady
// state all teeth slip continuously.

#include <ringmotor/motor/marching.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;

namespace
{
  constexpr unsigned int n_teeth = 20;
  constexpr double radius = 35e-3, compliance = 1e-7, pressed = 5., time_step = 1e-6;
  constexpr double mu_s = 0.5, mu_d = 0.3;

  CondensedMotor teeth_on_springs()
  {
    CondensedMotor motor;
    motor.n_teeth                = n_teeth;
    motor.n_waves                = 3;
    motor.wave.angular_frequency = 2. * M_PI * 30e3;
    motor.nodes.push_back({radius, 0., 1e-6});
    motor.wave.free_motion.emplace_back();
    const dealii::FullMatrix<double> basis{dealii::IdentityMatrix(3)};
    std::vector<std::complex<double>> of_wave(9);
    of_wave[0] = of_wave[4] = of_wave[8] = compliance;
    motor.compliance                     = RingCompliance(
                            n_teeth, basis, std::vector<std::vector<std::complex<double>>>(n_teeth / 2 + 1, of_wave));
    motor.constants = {1. / compliance, 1. / compliance};
    motor.tooth_compliance.reinit(3, 3);
    return motor;
  }

  Friction friction_of(const FrictionLaw law)
  {
    Friction friction;
    friction.law                 = law;
    friction.static_coefficient  = mu_s;
    friction.dynamic_coefficient = mu_d;
    friction.decay_velocity      = 0.2;
    friction.weakening_length    = 1e-6;
    return friction;
  }

  /** N on each tooth, against the rotor. */
  double friction_on_a_tooth(const OperatingState &state)
  {
    return -state.contact->torque(state.solution.state) / (n_teeth * radius);
  }

  /** Friction (N) while the rotor is turned by the distances (m) of successive steps. */
  std::vector<double> marched(const FrictionLaw law, const std::vector<double> &distances)
  {
    const CondensedMotor motor = teeth_on_springs();
    MarchingDriver driver(motor, friction_of(law), Warp(), n_teeth * pressed);
    std::vector<double> forces;
    for (const double distance : distances)
      forces.push_back(friction_on_a_tooth(
          driver.step({n_teeth * pressed, {}, distance / (radius * time_step)}, time_step)));
    return forces;
  }

  void expect_forces(const FrictionLaw law, const std::vector<double> &expected)
  {
    // At rest; 2 N, between both limits; 4 N, above; on, twice; back by 0.5 N; on by 1.2 N.
    const std::vector<double> found =
        marched(law, {0., 0.2e-6, 0.2e-6, 0.01e-6, 0.01e-6, -0.05e-6, 0.12e-6});
    for (unsigned int step = 0; step < expected.size(); ++step)
      EXPECT_NEAR(found[step], expected[step], 1e-6)
          << "law " << law.entry().name << ", step " << step;
  }
} // namespace

TEST(MarchedFriction, FollowsItsLawFromStepToStep)
{
  expect_forces(FrictionLaw("coulomb"), {0., 1.5, 1.5, 1.5, 1.5, 1., 1.5});
  // Beyond 2.5 N it falls to 1.5 N within the step, and has the static limit after sticking again.
  expect_forces(FrictionLaw("static-dynamic"), {0., 2., 1.5, 1.5, 1.5, 1., 2.2});
  // 2.5 N - 1e6 N/m times the distance slipped, over all steps since it last stuck.
  const double third = 2.5 - 1.5 / 9., on = 0.1 / 9., back = third - 2. * on - 0.5;
  expect_forces(FrictionLaw("slip-weakening"),
                {0., 2., third, third - on, third - 2. * on, back, 2.5 - (back + 1.2 - 2.5) / 9.});
}

TEST(SteadyFriction, IsThatOfPointsThatSlipAllAlong)
{
  const CondensedMotor motor = teeth_on_springs();
  constexpr double velocity  = 0.3; // m/s
  const double decayed       = mu_d + (mu_s - mu_d) * std::exp(-velocity / 0.2);
  for (const auto &[law, mu] :
       {std::pair(FrictionLaw("coulomb"), mu_d), std::pair(FrictionLaw("static-dynamic"), mu_d),
        std::pair(FrictionLaw("velocity"), decayed),
        std::pair(FrictionLaw("slip-weakening"), mu_d)})
  {
    SteadyDriver driver(motor, friction_of(law), {});
    const OperatingState state = driver.at({n_teeth * pressed, {}, velocity / radius});
    EXPECT_NEAR(friction_on_a_tooth(state), mu * pressed, 1e-6) << law.entry().name;
  }
}
