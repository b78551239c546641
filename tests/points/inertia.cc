// SPDX-License-Identifier: LGPL-2.1-or-later

// Inertia of the rotor. Known: a mode under a harmonic force has the amplitude and phase
// 1 / (omega^2 - Omega^2 + i eta omega Omega), through its resonance, up to second order in the
// step; masses on springs lifted by a travelling wave without friction press with (k - m Omega^2)
// A; marching with the same scheme stays in a steady state; powers balance.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/motor/marching.h>
#include <ringmotor/points/point_finder.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

using namespace ringmotor;
using namespace ringmotor::tests;
using Complex = std::complex<double>;

namespace
{
  constexpr double rpm = M_PI / 30.;

  /** Displacement over force of an oscillator under a harmonic force. */
  Complex exact_response(const double omega, const double loss_factor, const double of_force)
  {
    return 1. / Complex(omega * omega - of_force * of_force, loss_factor * omega * of_force);
  }

  double error_with(const InertiaScheme &scheme, const double of_force, const double n_steps)
  {
    const double dt     = 2. * M_PI / of_force / n_steps;
    const Complex exact = exact_response(1., 0.05, of_force);
    return std::abs(scheme.response(std::polar(1., of_force * dt), dt, 1., 0.05) - exact) /
           std::abs(exact);
  }
} // namespace

TEST(InertiaScheme, CrossesAResonanceAsTheoryDoes)
{
  const InertiaScheme scheme = InertiaScheme::second_order(0.8);
  for (const double of_force : {0.3, 0.9, 1., 1.1, 3.})
  {
    // Short steps: with longer ones dissipation, of third order, matters at the resonance.
    const double coarse = error_with(scheme, of_force, 400),
                 fine   = error_with(scheme, of_force, 800);
    EXPECT_LT(fine, 1e-4) << of_force;
    EXPECT_NEAR(std::log2(coarse / fine), 2., 0.1) << of_force;
  }
  EXPECT_NEAR(std::log2(error_with(InertiaScheme::newmark(0.6), 1., 200) /
                        error_with(InertiaScheme::newmark(0.6), 1., 400)),
              1., 0.1);
}

TEST(InertiaScheme, KeepsTheFrequencyOfAMode)
{
  // A force of the mode's own frequency meets it in quadrature, the static motion is exact, and
  // with a loss factor of 1e-3, 1 % beside the resonance, thirty steps in a period suffice for 2 %
  // (91 % without the mass factor).
  constexpr double loss_factor = 1e-3, of_force = 0.99;
  for (const double n_steps : {3.5, 10., 30.})
    for (const InertiaScheme &scheme :
         {InertiaScheme::second_order(0.5), InertiaScheme::second_order(0.8),
          InertiaScheme::newmark(0.6), InertiaScheme::newmark(1.)})
    {
      const double dt            = 2. * M_PI / n_steps;
      const Complex at_resonance = 1. / scheme.response(std::polar(1., dt), dt, 1., 0.);
      EXPECT_NEAR(at_resonance.real(), 0., 1e-12);
      EXPECT_GT(at_resonance.imag(), 0.); // dissipates
      EXPECT_NEAR(std::abs(scheme.response(std::polar(1., 1e-5), dt, 1., 0.)), 1., 1e-8);
      EXPECT_GT(scheme.response_in_step(dt, 1., 0.), 0.);
    }
  const double dt     = 2. * M_PI / 30.;
  const Complex exact = exact_response(1., loss_factor, of_force),
                found = InertiaScheme::second_order(0.8).response(std::polar(1., of_force * dt), dt,
                                                                  1., loss_factor);
  EXPECT_LT(std::abs(found - exact), 0.02 * std::abs(exact));
}

TEST(InertiaScheme, StepsSettleAtTheResponse)
{
  const double omega = 2., loss_factor = 0.1, of_force = 1.7, dt = 0.05;
  for (const InertiaScheme &scheme :
       {InertiaScheme::second_order(0.), InertiaScheme::second_order(0.8),
        InertiaScheme::newmark(0.6)})
  {
    ModalState state{};
    const unsigned int n_steps = 10000;
    for (unsigned int step = 1; step <= n_steps; ++step)
    {
      state                = without_force(scheme, state, dt, omega, loss_factor * omega);
      const Complex before = state.displacement, force = std::polar(1., of_force * dt * step);
      add_force(scheme, force, dt, omega, loss_factor * omega, state);
      EXPECT_LT(std::abs(state.displacement - before -
                         scheme.response_in_step(dt, omega, loss_factor * omega) * force),
                1e-12);
    }
    const Complex z            = std::polar(1., of_force * dt),
                  of_end       = std::polar(1., of_force * dt * n_steps),
                  displacement = scheme.response(z, dt, omega, loss_factor * omega) * of_end;
    EXPECT_LT(std::abs(state.displacement - displacement), 1e-9 * std::abs(displacement));
    EXPECT_LT(std::abs(state.velocity - scheme.velocity(z, dt) * displacement), 1e-8);
    EXPECT_LT(std::abs(state.acceleration - scheme.acceleration(z, dt) * displacement), 1e-8);
  }
}

namespace
{
  /** A rotor of masses on springs, one per tooth, lifted by a wave of normal amplitude. */
  CondensedMotor masses_on_springs(const double mass, const double frequency,
                                   const double loss_factor)
  {
    constexpr double amplitude = 1e-6, soft = 1e-9;
    CondensedMotor motor;
    motor.n_teeth                = 20;
    motor.n_waves                = 3;
    motor.wave.angular_frequency = 2. * M_PI * 30e3;
    motor.nodes.push_back({35e-3, 0., 1e-6});
    motor.wave.free_motion  = {{{amplitude, 0., 0.}}};
    const double compliance = 1. / (mass * frequency * frequency);
    dealii::FullMatrix<double> basis{dealii::IdentityMatrix(3)};
    std::vector<Complex> wave(9);
    wave[0] = compliance;
    wave[4] = wave[8] = soft;
    motor.compliance  = RingCompliance(20, basis, std::vector<std::vector<Complex>>(11, wave));
    motor.constants   = {1. / compliance, 1. / soft};
    motor.tooth_compliance.reinit(3, 3);
    motor.modes.resize(11);
    for (unsigned int k = 2; k <= 10; ++k)
      motor.modes[k].push_back({frequency, {{{1. / std::sqrt(mass), 0., 0.}}}});
    motor.dynamics = {loss_factor, InertiaScheme::second_order(0.9)};
    return motor;
  }
} // namespace

TEST(MassesOnSprings, PressAsTheyAreAccelerated)
{
  Friction none;
  none.law                 = FrictionLaw("coulomb");
  none.dynamic_coefficient = 0.;
  const double mass        = 1e-4;
  for (const double ratio :
       {0.5, 0.99, 1., 1.3, 3.}) // of the wave's frequency to that of the masses
  {
    const double wave_frequency = 2. * M_PI * 30e3, loss_factor = 0.02;
    const CondensedMotor motor = masses_on_springs(mass, wave_frequency / ratio, loss_factor);
    SteadyDriver driver(motor, none, {12, 1});
    const OperatingState state = driver.at({4000., {}, 1.});
    // With the phase of tooth 0 at the first time sample, where the wave has its crest.
    const Complex force =
        1e-6 * mass / exact_response(wave_frequency / ratio, loss_factor, wave_frequency);
    const double largest = 1e-6 * mass * std::pow(wave_frequency / std::min(ratio, 1.), 2);
    EXPECT_NEAR(state.solution.state.force[0][0] - 200., force.real(), 2e-3 * largest) << ratio;
    // The part that lags by a quarter of a period.
    double sum = 0.;
    for (unsigned int tooth = 0; tooth < 20; ++tooth)
      sum += 0.1 * (state.solution.state.force[tooth][0] - 200.) *
             std::sin(-2. * M_PI * 3. * tooth / 20.);
    EXPECT_NEAR(sum, -force.imag(), 2e-3 * largest) << ratio;
    // Only damping dissipates power: the mean of its force times velocity, summed over all masses.
    const double power = 20. * 0.5 * loss_factor * mass * wave_frequency / ratio *
                         std::pow(1e-6 * wave_frequency, 2);
    EXPECT_NEAR(state.modal_power.damped_by_factor * loss_factor, power, 3e-3 * power) << ratio;
    EXPECT_NEAR(state.modal_power.taken, power, 1e-2 * power) << ratio;
    EXPECT_LT(evaluate(state).power_imbalance(), 1e-9);
  }
}

TEST(MassesOnSprings, OfTheStatorLoseByLossFactorsOfTheirOwn)
{
  // In the static compliance is only a spring in series; each mode has its own loss factor.
  Friction none;
  none.law                 = FrictionLaw("coulomb");
  none.dynamic_coefficient = 0.;
  constexpr double mass = 1e-4, wave_frequency = 2. * M_PI * 30e3, loss_factor = 0.02;
  for (const double ratio : {0.5, 1., 1.3})
  {
    CondensedMotor motor = masses_on_springs(mass, wave_frequency / ratio, /*loss_factor =*/0.);
    for (std::vector<RingMode> &modes : motor.modes)
      for (RingMode &mode : modes)
      {
        mode.part        = ModePart::stator;
        mode.loss_factor = loss_factor;
      }
    SteadyDriver driver(motor, none, {12, 1});
    const OperatingState state = driver.at({4000., {}, 1.});
    const Complex of_mass =
        exact_response(wave_frequency / ratio, loss_factor, wave_frequency) / mass;
    const Complex force = 1e-6 / (1. / motor.constants.normal + of_mass);
    const double power  = -20. * 0.5 * wave_frequency * std::norm(force) * of_mass.imag();
    EXPECT_NEAR(state.modal_power.lost_in_stator, power, 2e-2 * power) << ratio;
    EXPECT_EQ(state.modal_power.damped_by_factor, 0.) << ratio;
    // It is a loss of the stator, which takes it from the wave.
    const OperatingPoint point = evaluate(state);
    EXPECT_NEAR(point.taken_from_wave(0.), state.modal_power.lost_in_stator, 1e-6 * power) << ratio;
    EXPECT_LT(point.power_imbalance(), 1e-9);
  }
}

TEST(MassesOnSprings, LagByTheirLossFactorWithoutInertia)
{
  Friction none;
  none.law                 = FrictionLaw("coulomb");
  none.dynamic_coefficient = 0.;
  const double mass = 1e-4, wave_frequency = 2. * M_PI * 30e3, loss_factor = 0.05;
  for (const double ratio : {0.5, 1., 3.}) // whatever the frequency
  {
    CondensedMotor motor         = masses_on_springs(mass, wave_frequency / ratio, loss_factor);
    motor.dynamics.is_hysteretic = true;
    SteadyDriver driver(motor, none, {12, 1});
    const OperatingState state = driver.at({40000., {}, 1.});
    const double force         = 1e-6 * mass * std::pow(wave_frequency / ratio, 2);
    EXPECT_NEAR(state.solution.state.force[0][0] - 2000., force, 1e-3 * force) << ratio;
    double sum = 0.;
    for (unsigned int tooth = 0; tooth < 20; ++tooth)
      sum += 0.1 * (state.solution.state.force[tooth][0] - 2000.) *
             std::sin(-2. * M_PI * 3. * tooth / 20.);
    EXPECT_NEAR(sum, -loss_factor * force, 1e-3 * loss_factor * force) << ratio;
    // Half of k eta A^2 per mass and radian.
    const double power = 20. * 0.5 * loss_factor * 1e-6 * force * wave_frequency;
    EXPECT_NEAR(state.modal_power.taken, power, 1e-3 * power) << ratio;
    EXPECT_NEAR(state.modal_power.damped_by_factor * loss_factor, power, 1e-3 * power) << ratio;
  }
}

namespace
{
  class VibratingMotor : public testing::Test
  {
  protected:
    static void SetUpTestSuite()
    {
      parameters                          = reference_motor();
      parameters.effects["Rotor inertia"] = EffectChoice::on;
      parameters.effects["Damping"]       = EffectChoice::on;
      motor = condense_motor(parameters, stator_wave(parameters), ContactDiscretisation::level(0));
    }

    static Parameters parameters;
    static CondensedMotor motor;
  };
  Parameters VibratingMotor::parameters = paper_motor();
  CondensedMotor VibratingMotor::motor;
  class VibratingMotorLong : public VibratingMotor
  {
  };

  /** Marches from the steady state, with 90 steps per period, and checks that torque, speed and
   * loss are unchanged after some periods. */
  void expect_stays(const Parameters &parameters, const CondensedMotor &motor,
                    const RotorLoad &load, const unsigned int n_periods)
  {
    const Friction friction = motor_model(parameters).friction;
    SteadyDriver steady(motor, friction, {motor.n_repeats(), 1});
    const OperatingState begin   = steady.at(load);
    const OperatingPoint settled = evaluate(begin);
    MarchingDriver marching(motor, friction, begin);
    OperatingState last = marching.step(load, motor.period() / 90.);
    NodePass pass(last.solution.status.size());
    std::vector<OperatingPoint> points;
    for (unsigned int step = 1; step < 90 * n_periods; ++step)
    {
      const OperatingState next = marching.step(load, motor.period() / 90.);
      points.push_back(evaluate_step(last, next, pass));
      pass.add(next.solution);
      last = next;
    }
    points.erase(points.begin(), points.end() - 45);
    const OperatingPoint now = mean(points, std::vector<double>(points.size(), 1.));
    // One sticking node more or less, of about forty that touch.
    EXPECT_NEAR(now.second_stick_fraction, settled.second_stick_fraction, 0.03);
    EXPECT_NEAR(now.speed, settled.speed, 1e-3 * settled.speed);
    EXPECT_NEAR(now.torque, settled.torque, 1e-3 * std::abs(settled.torque) + 1e-9);
    EXPECT_NEAR(now.friction_loss(), settled.friction_loss(), 1e-3 * settled.friction_loss());
    EXPECT_NEAR(now.modal_power, settled.modal_power, 1e-3 * settled.modal_power);
    EXPECT_NEAR(now.power_imbalance(), settled.power_imbalance(), 1e-4);
  }
} // namespace

TEST_F(VibratingMotor, IsTheSameFromTheChangeOfCoarseStates)
{
  const std::vector<PointRequest> requests{{Control::torque, 0.04},
                                           {Control::torque, 0.06},
                                           {Control::torque, 0.08},
                                           {Control::torque, 0.1},
                                           {Control::speed, 40. * rpm}};
  const auto points = [&](const unsigned int n_parts, const std::vector<CurvePoint> &starts)
  {
    return find_points({{parameters, motor, {0, 0, {n_parts}}, {}, requests, starts}},
                       MPI_COMM_SELF)
        .front();
  };
  const std::vector<CurvePoint> alone = points(2, {}), started = points(2, points(1, {}));
  for (std::size_t i = 1; i < requests.size(); ++i)
  {
    EXPECT_NEAR(started[i].result.speed, alone[i].result.speed, 1e-7 * alone[0].result.speed) << i;
    EXPECT_NEAR(started[i].result.torque, alone[i].result.torque, 1e-9) << i;
  }
}

TEST_F(VibratingMotor, MarchingStaysInTheSteadyState)
{
  expect_stays(parameters, motor, {14., 0.05}, 1);
}

TEST(SecondMotorLong, MarchingStaysInTheSteadyState)
{
  // Nine waves on ninety teeth: the steady state is that of ten teeth.
  Parameters second               = read_parameters(RINGMOTOR_SOURCE_DIR "/prm/ring60.prm");
  second.effects["Rotor inertia"] = second.effects["Damping"] = EffectChoice::on;
  second.accuracy.target                                      = 1e-3;
  const CondensedMotor ring60 =
      condense_motor(second, stator_wave(second), ContactDiscretisation::level(0));
  ASSERT_EQ(ring60.n_repeats(), 9u);
  // At a given speed: under a torque the speed of ten teeth is not constant, but the steady state
  // assumes so.
  expect_stays(second, ring60, {second.loading.preload, {}, 115. * rpm}, 10);
}

TEST_F(VibratingMotorLong, MarchingStaysInTheSteadyStateForTenPeriods)
{
  for (const double torque : {0., 0.05, 0.1})
    expect_stays(parameters, motor, {14., torque}, 10);
}

TEST_F(VibratingMotor, PowerGoesToLoadFrictionAndDamping)
{
  // With a scheme whose own dissipation is small.
  CondensedMotor other   = motor;
  other.dynamics.scheme  = InertiaScheme::second_order(0.99);
  const CurvePoint point = OperatingPointFinder(with_parts_of_a_step(parameters, 4), other)
                               .find({Control::torque, 0.05});
  EXPECT_LT(point.result.power_imbalance(), 1e-3);
  const double damping = parameters.materials.rotor_metal.loss_factor * point.result.modal_damping;
  EXPECT_GT(damping, 0.01);
  EXPECT_NEAR(point.result.modal_power, damping, 0.02 * damping);
}

TEST_F(VibratingMotor, PowerBalancesWhileItSettles)
{
  // From rest, while modes absorb energy.
  MarchingDriver marching(motor, motor_model(parameters).friction, Warp(), 14.);
  const RotorLoad load{14., {}, 70. * rpm};
  const double step   = motor.period() / 360.;
  OperatingState last = marching.step(load, step);
  const NodePass begins(last.solution.status.size());
  std::vector<OperatingPoint> points;
  for (unsigned int i = 0; i < 90; ++i) // a quarter of a period
  {
    const OperatingState next = marching.step(load, step);
    points.push_back(evaluate_step(last, next, begins));
    last = next;
  }
  const OperatingPoint begin = mean(points, std::vector<double>(points.size(), 1.));
  record("power imbalance", begin.power_imbalance());
  EXPECT_GT(std::abs(begin.modal_power), 0.1 * std::abs(begin.input_power));
  EXPECT_LT(begin.power_imbalance(), 2e-3);
}

TEST_F(VibratingMotor, IsTheSameAtStallWhateverTheWayThere)
{
  // From no load to stall in one step, in all ways: where Newton's method at once does not
  // converge, the others are taken. The state is that found from rest. These cells are, at the top
  // of the tooth, thicker than those of the sequence, which makes the step hard.
  ContactDiscretisation discretisation = ContactDiscretisation::level(0);
  discretisation.tooth.ratio           = 0.25;
  const CondensedMotor motor = condense_motor(parameters, stator_wave(parameters), discretisation);
  const Friction friction    = motor_model(parameters).friction;
  const SteadyStep step{motor.n_repeats(), 1};
  const RotorLoad no_load{14., 0.}, stall{14., {}, 0.};
  const OperatingPoint from_rest = evaluate(SteadyDriver(motor, friction, step).at(stall));
  for (const auto way : {SteadyDriver::Way::at_once, SteadyDriver::Way::by_some_damping,
                         SteadyDriver::Way::by_strong_damping})
  {
    SteadyDriver driver(motor, friction, step);
    driver.at(no_load);
    const OperatingPoint from_no_load = evaluate(driver.at(stall, way));
    EXPECT_NEAR(from_no_load.torque, from_rest.torque, 1e-8) << static_cast<int>(way);
    EXPECT_NEAR(from_no_load.friction_loss(), from_rest.friction_loss(), 1e-7)
        << static_cast<int>(way);
  }
}

TEST_F(VibratingMotor, TwiceAsManyTeethTouch)
{
  const CurvePoint point = OperatingPointFinder(parameters, motor).find({Control::torque, 0.});
  record("teeth in contact per wave", point.result.teeth_in_contact);
  EXPECT_GT(point.result.teeth_in_contact, 6.);
  EXPECT_LT(point.result.teeth_in_contact, 8.);
}
