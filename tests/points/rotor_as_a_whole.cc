// SPDX-License-Identifier: LGPL-2.1-or-later

// Inertia of the rotor as a whole, as included in marching: closed forms of a mass on a spring and
// of a damped mass; mass and tilting inertia of two annuli; the power balance of each step.
// Hysteresis of a rotor without inertia: the loss is eta times the circulating elastic energy, and
// a resting force lags by eta.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/motor/marching.h>
#include <ringmotor/points/marched_point.h>
#include <ringmotor/points/point_finder.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  CondensedMotor free_mass(const double mass)
  {
    CondensedMotor motor;
    motor.rotor_mass      = mass;
    motor.dynamics.scheme = InertiaScheme::second_order(0.8);
    return motor;
  }

  /** A mass moved by a constant force against a spring from rest. */
  struct Swing
  {
    double displacement = 0., work_into_inertia = 0.;

    Swing(const double mass, const double spring, const double force, const double time,
          const unsigned int n_steps, const double damping = 0.)
    {
      const CondensedMotor motor = free_mass(mass);
      MarchedRigidMotions rise(motor, rigid_motions_at_rest({0.}));
      rise.damping    = damping;
      const double dt = time / n_steps;
      for (unsigned int step = 0; step < n_steps; ++step)
      {
        const InertiaInStep inertia = rise.in_step(dt).front();
        displacement                = (force + inertia.load) / (spring + inertia.stiffness);
        work_into_inertia += rise.step({displacement}, dt) * dt;
      }
    }
  };
} // namespace

TEST(RigidInertia, SwingsOnASpring)
{
  const double mass = 0.02, spring = 7e6, force = 14., omega = std::sqrt(spring / mass),
               time = 2. / omega, exact = force / spring * (1. - std::cos(2.));
  const Swing coarse(mass, spring, force, time, 200), fine(mass, spring, force, time, 400);
  EXPECT_NEAR(fine.displacement, exact, 1e-2 * exact);
  // The jump of the force at the start reduces the order to one.
  EXPECT_NEAR(
      std::log2(std::abs(coarse.displacement - exact) / std::abs(fine.displacement - exact)), 1.,
      0.3);
  const double energy = 0.5 * mass * std::pow(force / spring * omega * std::sin(2.), 2);
  EXPECT_NEAR(fine.work_into_inertia, energy, 2e-2 * energy);
}

TEST(RigidInertia, DampedMassGoesOnEvenly)
{
  // Finally F = M d v: during another 2/d the distance is 2 F / (M d^2).
  const double mass = 0.02, damping = 1e4, force = 14.,
               way = Swing(mass, 0., force, 22. / damping, 2200, damping).displacement -
                     Swing(mass, 0., force, 20. / damping, 2000, damping).displacement;
  EXPECT_NEAR(way, 2. * force / (mass * damping * damping), 1e-6 * way);
}

namespace
{
  /** A motor that is marched, with a rotor that moves as a whole. */
  class RotorAsAWhole : public testing::Test
  {
  protected:
    static void SetUpTestSuite()
    {
      parameters                          = reference_motor();
      parameters.time.scheme              = TimeScheme::marching;
      parameters.effects["Rotor inertia"] = EffectChoice::on;
      parameters.effects["Damping"]       = EffectChoice::on;
      motor =
          condense_motor(parameters, stator_wave(parameters), ContactDiscretisation::level(0), 1);
    }

    static Parameters parameters;
    static CondensedMotor motor;
  };
  Parameters RotorAsAWhole::parameters = paper_motor();
  CondensedMotor RotorAsAWhole::motor;
} // namespace

TEST_F(RotorAsAWhole, HasTheInertiaOfTwoAnnuli)
{
  const RotorGeometry &rotor = parameters.rotor;
  const double density       = parameters.materials.rotor_metal.density,
               bars          = rotor.ring_upper_face - 0.5 * rotor.radial_bar_height;
  double mass = 0., tilt = 0.; // about a diameter at the height of the bars
  const auto add_annulus =
      [&](const double inner, const double outer, const double low, const double high)
  {
    const double squares = outer * outer + inner * inner, height = high - low,
                 m = density * M_PI * (outer * outer - inner * inner) * height;
    mass += m;
    tilt += m * (0.25 * squares + height * height / 12. + std::pow(0.5 * (low + high) - bars, 2));
  };
  const double inner = rotor.ring_inner_radius, outer = rotor.ring_outer_radius;
  add_annulus(inner, outer, rotor.ring_lower_face, rotor.ring_upper_face);
  add_annulus(rotor.lip_inner_radius, inner, rotor.flange_lower_face,
              rotor.flange_lower_face + rotor.flange_thickness);
  EXPECT_NEAR(motor.rotor_mass, mass, 1e-5 * mass);
  // From the mean rise of the ring's top: its radius is that of the centroid of its area.
  const double radius =
      2. / 3. * (std::pow(outer, 3) - std::pow(inner, 3)) / (outer * outer - inner * inner);
  ASSERT_EQ(motor.near_rigid_modes.size(), 1u);
  record("tilting inertia over that of two annuli",
         motor.near_rigid_modes[0].inertia * radius * radius / tilt);
  EXPECT_NEAR(motor.near_rigid_modes[0].inertia * radius * radius, tilt, 1e-2 * tilt);
}

TEST_F(RotorAsAWhole, VibratesInAllNodalDiametersFromTwoOn)
{
  EXPECT_TRUE(motor.modes[0].empty() && motor.modes[1].empty());
  for (unsigned int k = 2; k <= 40; ++k) // with more waves all modes lie above the requested range
    EXPECT_FALSE(motor.modes[k].empty()) << k;
}

TEST_F(RotorAsAWhole, TakesThePowerThatItsMotionNeeds)
{
  // From rest over a warp that tilts the rotor, with the torque of friction: it bounces.
  MarchingDriver marching(motor, motor_model(parameters).friction, {1e-6, 1}, 14.);
  const RotorLoad load{14., {}, 7.};
  const double step   = motor.period() / 90.;
  OperatingState last = marching.step(load, step);
  const NodePass begins(last.solution.status.size());
  double largest = 0.;
  for (unsigned int i = 0; i < 60; ++i)
  {
    const OperatingState next  = marching.step(load, step);
    const OperatingPoint point = evaluate_step(last, next, begins);
    last                       = next;
    EXPECT_NEAR(point.input_power - point.output_work - point.friction_loss() - point.stored_power -
                    point.modal_power,
                point.closing_work, 1e-7 * point.gross_power)
        << i;
    double rigid = 0.;
    for (const double motion : last.solution.state.rigid)
      rigid = std::max(rigid, std::abs(motion));
    largest = std::max(largest, rigid);
  }
  EXPECT_GT(largest, 1e-7);
}

TEST_F(RotorAsAWhole, GoesOnFromItsStateAsIfItHadNotStopped)
{
  const Friction friction = motor_model(parameters).friction;
  const Warp warp{1e-6, 1};
  const RotorLoad load{14., {}, 7.};
  const double step = motor.period() / 90.;
  MarchingDriver marching(motor, friction, warp, 14.);
  for (unsigned int i = 0; i < 30; ++i)
    marching.step(load, step);
  MarchingDriver other(motor, friction, warp, marching.state());
  for (unsigned int i = 0; i < 5; ++i)
  {
    const std::vector<PointVector> force = marching.step(load, step).solution.state.force,
                                   same  = other.step(load, step).solution.state.force;
    double largest = 0., difference = 0.;
    for (unsigned int point = 0; point < force.size(); ++point)
    {
      largest    = std::max(largest, force[point].norm());
      difference = std::max(difference, (force[point] - same[point]).norm());
    }
    EXPECT_LT(difference, 1e-8 * largest) << i;
  }
}

TEST_F(RotorAsAWhole, LosesTheSameShareOfAllVibrationsInAPeriod)
{
  // Lifted off the teeth: the amplitude of each mode falls by exp(pi eta) in a period of the wave,
  // whatever its frequency. Those that steps resolve, as the scheme damps faster ones; the
  // energy of slow ones swings within their period.
  MarchingDriver marching(motor, motor_model(parameters).friction, {1e-6, 1}, 14.);
  const double step = motor.period() / 360.;
  for (unsigned int i = 0; i < 60; ++i)
    marching.step({14., {}, 7.}, step);
  constexpr double loss_factor = 0.1, resolved = 0.1; // rad in a step
  marching.damp(loss_factor);
  const auto energies = [&]
  {
    std::vector<double> of_modes;
    const MarchedState state = marching.state();
    for (unsigned int k = 0; k < state.modes.size(); ++k)
      for (unsigned int r = 0; r < state.modes[k].size(); ++r)
        if (const double omega = motor.modes[k][r].angular_frequency; omega * step < resolved)
          of_modes.push_back(std::norm(state.modes[k][r].velocity) +
                             std::norm(omega * state.modes[k][r].displacement));
    return of_modes;
  };
  const auto in_the_air = [&] { marching.step({-1e4, {}, 7.}, step); };
  for (unsigned int i = 0; i < 20; ++i)
    in_the_air();
  const std::vector<double> begin = energies();
  for (unsigned int i = 0; i < 360; ++i)
    in_the_air();
  const std::vector<double> end = energies();
  const double expected         = std::exp(-2. * M_PI * loss_factor);
  ASSERT_GT(begin.size(), 20u);
  for (unsigned int i = 0; i < begin.size(); ++i)
    EXPECT_NEAR(end[i] / begin[i], expected, 0.3 * expected) << i;
  const double whole =
      std::accumulate(end.begin(), end.end(), 0.) / std::accumulate(begin.begin(), begin.end(), 0.);
  EXPECT_NEAR(whole, expected, 0.2 * expected);
}

class RotorAsAWholeLong : public RotorAsAWhole
{
};

TEST_F(RotorAsAWholeLong, WandersAboutTheMeanOfItsPoint)
{
  // Over a warp it has no period: its point must have the mean of a run of several times the
  // length.
  Parameters warped                     = parameters;
  warped.initial_deformation.amplitude  = 1e-6;
  warped.initial_deformation.n_waves    = 2;
  warped.effects["Initial deformation"] = EffectChoice::on;
  warped.time.time_step                 = motor.period() / 32.;
  warped.accuracy.contact_target        = 0.1;
  const PointRequest request{Control::speed, 60. * M_PI / 30.};
  const CurvePoint point = find_marched(warped, motor, request);
  MarchedRun run(warped, motor, request, 1, &point.end);
  const double step          = point.fields.time_step;
  const OperatingPoint later = run.advance(32 * 30, step).mean;
  record("torque of the point and of thirty periods more (mN m)", 1e3 * point.result.torque);
  record("torque of the point and of thirty periods more (mN m)", 1e3 * later.torque);
  record("error bar of the averaging window (mN m)", 1e3 * point.unsettled_means["torque"]);
  record("friction loss of both (mW)", 1e3 * point.result.friction_loss());
  record("friction loss of both (mW)", 1e3 * later.friction_loss());
  record("its error bar (mW)", 1e3 * point.unsettled_means["friction_loss"]);
  record("periods marched", point.end.end.time / motor.period());
  EXPECT_NEAR(point.result.torque, later.torque, 1.5 * point.unsettled_means["torque"]);
  EXPECT_NEAR(point.result.friction_loss(), later.friction_loss(),
              1.5 * point.unsettled_means["friction_loss"]);
}

TEST_F(RotorAsAWhole, RisesAndTiltsAsForcesAccelerateIt)
{
  // Rise: M z'' is the excess of the contact forces over the preload, with second-order differences
  // of a smooth motion.
  MarchingDriver marching(motor, motor_model(parameters).friction, Warp(), 14.);
  const double step = motor.period() / 360.;
  std::vector<double> rise, force;
  for (unsigned int i = 0; i < 200; ++i)
  {
    const OperatingState state = marching.step({14., {}, 7.}, step);
    rise.push_back(state.solution.state.rigid[0]);
    force.push_back(-14.);
    for (const PointVector &of_node : state.solution.state.force)
      force.back() += of_node[0];
  }
  // Momentum: the change of mean speed follows from the impulse in between.
  double impulse = 0.;
  for (unsigned int i = 20; i < 180; ++i)
    impulse += force[i] * step;
  const double begin = 0.5 * (rise[20] - rise[18]) / step,
               end   = 0.5 * (rise[180] - rise[178]) / step;
  double largest     = 0.;
  for (const double excess : force)
    largest = std::max(largest, std::abs(excess) * 160. * step);
  record("change of momentum over impulse", motor.rotor_mass * (end - begin) / impulse);
  EXPECT_NEAR(motor.rotor_mass * (end - begin), impulse, 0.02 * largest);
}

namespace
{
  CurvePoint at_fifty(const EffectChoice damping, const double loss_factor)
  {
    Parameters parameters                        = reference_motor();
    parameters.effects["Damping"]                = damping;
    parameters.materials.rotor_metal.loss_factor = loss_factor;
    const CondensedMotor motor =
        condense_motor(parameters, stator_wave(parameters), ContactDiscretisation::level(0), 1);
    return OperatingPointFinder(with_parts_of_a_step(parameters, 3), motor)
        .find({Control::torque, 0.05});
  }
} // namespace

TEST(Hysteresis, LosesItsShareOfTheElasticEnergy)
{
  const double loss_factor  = 0.02;
  const CurvePoint elastic  = at_fifty(EffectChoice::off, loss_factor),
                   damped   = at_fifty(EffectChoice::on, loss_factor);
  const OperatingPoint &now = damped.result;
  EXPECT_LT(now.power_imbalance(), 1e-3);
  // The power put into the rotor is that given by its loss factor, ...
  EXPECT_GT(now.modal_power, 1e-3);
  EXPECT_NEAR(now.modal_power, loss_factor * now.modal_damping, 1e-6 * now.modal_power);
  // ... which is known from the elastic energy of all harmonics without damping.
  record("internal loss over that from elastic energy", damped.rotor_power / elastic.rotor_power);
  EXPECT_NEAR(damped.rotor_power, elastic.rotor_power, 0.05 * elastic.rotor_power);
  EXPECT_GT(now.modal_damping, 0.5 * damped.rotor_power);
  // Such a phase lag changes speeds only slightly.
  EXPECT_NE(now.speed, elastic.result.speed);
  EXPECT_NEAR(now.speed, elastic.result.speed, loss_factor * elastic.result.speed);
}
