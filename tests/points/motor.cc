// SPDX-License-Identifier: LGPL-2.1-or-later

// The behaviour of the reference motor. Speeds under four loads: an independent model of the same
// motor (its own solid meshes, its own contact) gave 85.3, 82.7, 79.0 and 73.4 rpm and friction
// losses of 41, 70, 137 and 252 mW with one coefficient of friction 0.40; at stall all friction
// acts in one direction, mu F r. Observations of Maeno et al. (1992): crests touch along the outer
// line with three to four teeth per wave; forces are steady after the fifth step of 5e-7 s; without
// load friction has both signs and cancels; a point slips backwards, sticks, slips forwards; warp
// reduces the speed. And exact power balances: the input of the teeth equals the output of the
// rotor plus the friction loss.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/motor/marching.h>
#include <ringmotor/points/point_finder.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double rpm = M_PI / 30.;

  class ReferenceMotor : public testing::Test
  {
  protected:
    static void SetUpTestSuite()
    {
      parameters = reference_motor();
      motor = condense_motor(parameters, stator_wave(parameters), ContactDiscretisation::level(1));
    }
    CurvePoint at_torque(const double torque, const unsigned int n_samples = 1) const
    {
      return OperatingPointFinder(with_parts_of_a_step(parameters, n_samples), motor)
          .find({Control::torque, torque});
    }

    static Parameters parameters;
    static CondensedMotor motor;
  };
  Parameters ReferenceMotor::parameters = paper_motor();
  CondensedMotor ReferenceMotor::motor;

  double force_sum(const ContactFields &fields, const unsigned int component, const double sign)
  {
    double sum = 0.;
    for (const PointVector &force : fields.state.force)
      sum += std::max(0., sign * force[component]);
    return sum;
  }
} // namespace

TEST_F(ReferenceMotor, TurnsAsFastAsAnIndependentModel)
{
  OperatingPointFinder finder(parameters, motor);
  struct Expected
  {
    double torque, speed, loss; // N m, rpm, mW
  };
  for (const auto &[torque, speed, loss] : {Expected{0., 85.3, 41.}, Expected{0.05, 82.7, 70.},
                                            Expected{0.1, 79.0, 137.}, Expected{0.15, 73.4, 252.}})
  {
    const CurvePoint point = finder.find({Control::torque, torque});
    record("speed at 0, 50, 100, 150 mN m (rpm)", point.result.speed / rpm);
    EXPECT_NEAR(point.result.speed / rpm, speed, 0.01 * speed) << torque;
    // The two finest meshes of that model differ by 3 mW without load, and by at most a tenth.
    record("friction loss at 0, 50, 100, 150 mN m (mW)", 1e3 * point.result.friction_loss());
    EXPECT_NEAR(1e3 * point.result.friction_loss(), loss, 0.1 * loss + 3.) << torque;
    EXPECT_NEAR(point.result.torque, torque, 1e-9);
    EXPECT_LE(point.largest_violation, ContactCertificate::limit);
  }
}

TEST_F(ReferenceMotor, StallsWhereAllFrictionPointsOneWay)
{
  const CurvePoint point = OperatingPointFinder(parameters, motor).find({Control::speed, 0.});
  record("stall torque (mN m)", 1e3 * point.result.torque);
  // The contact lies along the outer line; radial sliding causes a small share of the friction.
  EXPECT_NEAR(point.result.torque, 0.40 * 14. * 34.2e-3, 0.002 * 0.40 * 14. * 34.2e-3);
  EXPECT_LT(point.result.stick_fraction, 1e-6);
}

TEST_F(ReferenceMotor, SpeedAndTorqueControlAreTwoWaysToOnePoint)
{
  for (const unsigned int n_samples : {1u, 3u})
  {
    const CurvePoint loaded = at_torque(0.08, n_samples);
    const CurvePoint driven =
        OperatingPointFinder(with_parts_of_a_step(parameters, n_samples), motor)
            .find({Control::speed, loaded.result.speed});
    EXPECT_NEAR(driven.result.torque, 0.08, 1e-8);
  }
}

TEST_F(ReferenceMotor, TouchesAtTheCrestsAlongTheOuterLine)
{
  const CurvePoint point = at_torque(0.);
  record("teeth in contact per wave", point.result.teeth_in_contact);
  EXPECT_GT(point.result.teeth_in_contact, 3.);
  EXPECT_LT(point.result.teeth_in_contact, 4.);
  double inside = 0.;
  for (unsigned int i = 0; i < point.fields.state.force.size(); ++i)
    if (motor.nodes[i % motor.nodes.size()].radius < 34.0e-3)
      inside += point.fields.state.force[i][0];
  record("share of the normal force at r < 34.0 mm", inside / 14.);
  EXPECT_LT(inside, 0.02 * 14.);
  for (unsigned int i = 0; i < point.fields.state.force.size(); ++i)
    if (point.fields.state.force[i][0] > 0.)
    {
      EXPECT_GT(point.fields.tooth[i][0], 1e-6) << "only crests touch, 2 um high";
    }
}

TEST_F(ReferenceMotor, HasFrictionOfBothSignsWithoutLoad)
{
  const CurvePoint point = at_torque(0.);
  const double forwards  = force_sum(point.fields, 1, 1.),
               backwards = force_sum(point.fields, 1, -1.);
  record("friction forwards, backwards (N)", forwards);
  record("friction forwards, backwards (N)", backwards);
  EXPECT_NEAR(forwards, backwards, 1e-3 * forwards); // torques cancel, at nearly one radius
  EXPECT_GT(forwards, 0.1 * 0.40 * 14.);
}

namespace
{
  /** What a contact node does while the wave passes, in 90 steps: it is open (o), friction brakes
   * (b) or drives (d) the rotor there, or it sticks (s). */
  std::string story_of(const CurvePoint &point, const std::size_t n_nodes, const unsigned int node)
  {
    std::string story;
    for (unsigned int step = 0; step < 90; ++step)
    {
      // Tooth j is where tooth 0 was earlier: 13 teeth further on, the wave is one step behind.
      const unsigned int tooth = (45 * 90 - 13 * (step + 45)) % 90;
      const std::size_t i      = tooth * n_nodes + node;
      const auto status        = point.fields.status[i];
      story += status == PointStatus::open           ? 'o'
               : status == PointStatus::stick        ? 's'
               : point.fields.state.force[i][1] > 0. ? 'd'
                                                     : 'b';
    }
    return story;
  }
} // namespace

TEST_F(ReferenceMotor, BrakesSticksAndDrivesAtANode)
{
  const CurvePoint point = at_torque(0.);
  unsigned int node      = 0;
  for (unsigned int a = 0; a < motor.nodes.size(); ++a)
    if (motor.nodes[a].radius > 34.19e-3 && std::abs(motor.nodes[a].angle) < 1e-9)
      node = a;
  std::string story = story_of(point, motor.nodes.size(), node);
  story.erase(std::unique(story.begin(), story.end()), story.end());
  RecordProperty("history: o open, b braked, s sticks, d driven", story);
  EXPECT_NE((story + story).find("obsd"), std::string::npos)
      << story << " should be: open, braked, sticks, driven";
}

TEST_F(ReferenceMotor, CountsTheSecondSticksOfAllNodes)
{
  const CurvePoint point = at_torque(0.);
  double pressed = 0., again = 0.;
  for (unsigned int node = 0; node < motor.nodes.size(); ++node)
  {
    const std::string once = story_of(point, motor.nodes.size(), node), story = once + once;
    for (unsigned int step = 90; step < 180; ++step)
    {
      const unsigned int tooth = (45 * 90 - 13 * (step - 90 + 45)) % 90;
      const double force       = point.fields.state.force[tooth * motor.nodes.size() + node][0];
      const auto contact       = story.find_last_of('o', step);
      pressed += force;
      if (story[step] == 's' && contact != std::string::npos &&
          story.substr(contact, step - contact).find('d') != std::string::npos)
        again += force;
    }
  }
  record("second stick fraction", again / pressed);
  EXPECT_GT(again, 0.);
  EXPECT_NEAR(point.result.second_stick_fraction, again / pressed, 1e-12);
}

namespace
{
  /** The defect of the powers, each from its own formula, in the one balance that holds exactly. */
  double defect_of(const OperatingPoint &point)
  {
    return std::abs(point.input_power - point.output_work - point.friction_loss() -
                    point.stored_power - point.closing_work) /
           std::max(std::abs(point.input_power), point.friction_loss());
  }
} // namespace

TEST_F(ReferenceMotor, BalancesItsPower)
{
  // The input at the teeth's feet equals the rotor's output plus the friction loss, except for the
  // work of gaps that close within a step, which decreases with the step.
  for (const double torque : {0.05, 0.1, 0.15})
  {
    const OperatingPoint result = at_torque(torque).result;
    record("power imbalance at 50, 100, 150 mN m", result.power_imbalance());
    EXPECT_LT(result.power_imbalance(), OperatingPoint::largest_imbalance) << torque;
    EXPECT_LT(defect_of(result), 1e-9) << torque;
    EXPECT_NEAR(result.output_work, result.output_power(), 1e-9 * result.input_power);
    EXPECT_EQ(result.stored_power, 0.);
  }
  // Without load little power is left to compare with.
  const CondensedMotor coarse =
      condense_motor(parameters, stator_wave(parameters), ContactDiscretisation::level(0));
  std::vector<double> imbalance;
  for (const unsigned int n_samples : {1u, 3u, 6u})
  {
    const OperatingPoint result =
        OperatingPointFinder(with_parts_of_a_step(parameters, n_samples), coarse)
            .find({Control::torque, 0.})
            .result;
    imbalance.push_back(result.power_imbalance());
    EXPECT_LT(defect_of(result), 1e-9) << n_samples;
  }
  record("power imbalance without load, 1, 6 time samples", imbalance[0]);
  record("power imbalance without load, 1, 6 time samples", imbalance[2]);
  EXPECT_LT(imbalance[2], OperatingPoint::largest_imbalance);
  EXPECT_LT(imbalance[2], 0.5 * imbalance[0]);
}

TEST_F(ReferenceMotor, BalancesThePowerOfEachStepOnItsWay)
{
  // From rest, over a warp that tilts the rotor: elastic energy, tilts and rise all change. With
  // increased stiffness of the rotor's tilts, their springs store as much as the rest.
  CondensedMotor stiff = motor;
  for (CondensedMotor::NearRigidMode &loose : stiff.near_rigid_modes)
    loose.stiffness *= 1e3;
  for (const CondensedMotor *which : {&motor, &stiff})
    for (const RotorLoad &load : {RotorLoad{14., {}, 70. * rpm}, RotorLoad{14., 0.05}})
    {
      MarchingDriver driver(*which, parameters.friction, Warp{4e-6, 1}, load.preload);
      OperatingState last = driver.step({14., {}, 70. * rpm}, 5e-7);
      const NodePass begins(last.solution.status.size());
      std::vector<OperatingPoint> steps;
      double largest = 0., stored = 0.;
      for (unsigned int step = 0; step < 8; ++step)
      {
        const OperatingState state = driver.step(load, 5e-7);
        steps.push_back(evaluate_step(last, state, begins));
        largest = std::max(largest, defect_of(steps.back()));
        stored  = std::max(stored, std::abs(steps.back().stored_power) / steps.back().input_power);
        last    = state;
      }
      const OperatingPoint all = mean(steps, std::vector<double>(steps.size(), 1.));
      const std::string at =
          std::string(load.torque ? ", given torque" : ", given speed") + ", usual and stiff tilts";
      record("largest defect with the work on closing gaps" + at, largest);
      record("largest stored over input power" + at, stored);
      record("mean output power over output work, less 1" + at,
             all.output_power() / all.output_work - 1.);
      EXPECT_GT(stored, 0.05) << "what is stored could not be forgotten";
      EXPECT_LT(largest, 1e-9);
      EXPECT_LT(defect_of(all), 1e-9);
    }
}

TEST_F(ReferenceMotor, IsSteadyAfterFiveOfThePapersSteps)
{
  const MarchingDriver fresh(motor, parameters.friction, Warp(), 14.);
  MarchingDriver driver = fresh;
  const RotorLoad load{14., {}, 60. * rpm};
  std::vector<double> torque;
  for (unsigned int step = 0; step < 15; ++step)
  {
    const OperatingState state = driver.step(load, 5e-7);
    torque.push_back(state.contact->torque(state.solution.state));
    record("torque after steps 1 to 15 (mN m)", 1e3 * torque.back());
  }
  const double steady =
      OperatingPointFinder(parameters, motor).find({Control::speed, 60. * rpm}).result.torque;
  record("steady torque (mN m)", 1e3 * steady);
  EXPECT_LT(torque[0], 0.95 * steady);
  for (unsigned int step = 5; step < 15; ++step)
    EXPECT_NEAR(torque[step], steady, 0.01 * steady) << step;
}

TEST_F(ReferenceMotor, MarchesToItsSteadyState)
{
  // With the step of the steady scheme both solve the same equations.
  MarchingDriver driver(motor, parameters.friction, Warp(), 14.);
  const RotorLoad load{14., 0.08};
  double speed = 0.;
  for (unsigned int step = 0; step < 90; ++step)
  {
    const OperatingState state = driver.step(load, motor.period() / 90.);
    speed                      = state.contact->speed(state.solution.state);
  }
  const double steady = at_torque(0.08).result.speed;
  record("relative difference of speeds", speed / steady - 1.);
  EXPECT_NEAR(speed, steady, 1e-5 * speed);
}

TEST_F(ReferenceMotor, RemembersHowFarItsPointsHaveSlipped)
{
  // From a crest that touches to a ring pressed nearly flat: at each contact node the friction that
  // the law allows for the distance slipped since it last stuck or came into contact.
  Friction friction            = parameters.friction;
  friction.law                 = FrictionLaw("slip-weakening");
  friction.static_coefficient  = 0.48;
  friction.dynamic_coefficient = 0.40;
  friction.weakening_length    = 1e-7;
  for (const double preload : {14., 200.})
  {
    SteadyDriver driver(motor, friction, {});
    const OperatingState state   = driver.at({preload, {}, 40. * rpm});
    const ContactSolution &found = state.solution;
    unsigned int n_between       = 0; // points on the slope of the law
    for (unsigned int point = 0; point < state.contact->n_points(); ++point)
    {
      const PointVector &force = found.state.force[point];
      if (force[0] <= 0.)
        continue;
      double slipped = tangential_norm(found.motion[point]);
      for (unsigned int before                               = state.contact->earlier(point);
           found.status[before] == PointStatus::slip; before = state.contact->earlier(before))
        slipped += tangential_norm(found.motion[before]);
      const double mu = 0.40 + 0.08 * std::max(0., 1. - slipped / 1e-7);
      if (found.status[point] == PointStatus::slip)
      {
        EXPECT_NEAR(tangential_norm(force), mu * force[0], 1e-6 * force[0]) << point;
        n_between += mu > 0.402 && mu < 0.478;
      }
      else
      {
        EXPECT_LE(tangential_norm(force), (mu + 1e-6) * force[0]) << point;
      }
    }
    record("contact nodes between both coefficients, 14, 200 N", n_between);
    EXPECT_GT(n_between, 0u) << "nothing would be seen of the law";
  }
}

TEST_F(ReferenceMotor, MarchesToItsSteadyStateWhereFrictionFallsWithTheSlip)
{
  Parameters weakening                        = parameters;
  weakening.friction.law                      = FrictionLaw("slip-weakening");
  weakening.friction.static_coefficient       = 0.56;
  weakening.friction.weakening_length         = 1e-7;
  weakening.effects["Static friction excess"] = EffectChoice::on;
  for (const double speed : {0., 40. * rpm})
  {
    const double steady =
        OperatingPointFinder(weakening, motor).find({Control::speed, speed}).result.torque;
    MarchingDriver driver(motor, weakening.friction, Warp(), 14.);
    double torque = 0.;
    for (unsigned int step = 0; step < 180; ++step)
    {
      const OperatingState state = driver.step({14., {}, speed}, motor.period() / 90.);
      torque                     = state.contact->torque(state.solution.state);
    }
    record("relative difference of torques", torque / steady - 1.);
    EXPECT_NEAR(torque, steady, 1e-5 * torque);
  }
}

TEST_F(ReferenceMotor, IsSlowerWhenWarped)
{
  Parameters warped                    = parameters;
  warped.initial_deformation.amplitude = 4e-6;
  const CurvePoint slow = OperatingPointFinder(warped, motor).find({Control::torque, 0.05});
  const double even     = at_torque(0.05).result.speed;
  record("speed, with and without the warp (rpm)", slow.result.speed / rpm);
  record("speed, with and without the warp (rpm)", even / rpm);
  EXPECT_LT(slow.result.speed, even - 3. * rpm);
  EXPECT_GT(slow.result.speed, 0.8 * even);
}

TEST_F(ReferenceMotor, FeelsItsFrictionAndItsStiffness)
{
  // Another motor gives other results, so the tests above can fail.
  Parameters smoother                   = parameters;
  smoother.friction.dynamic_coefficient = 0.30;
  EXPECT_LT(OperatingPointFinder(smoother, motor).find({Control::torque, 0.1}).result.speed,
            at_torque(0.1).result.speed - 1. * rpm);
  Parameters softer = parameters;
  softer.materials.rotor_metal.young_modulus *= 0.5;
  const CondensedMotor soft =
      condense_motor(softer, stator_wave(softer), ContactDiscretisation::level(1));
  const CurvePoint point = OperatingPointFinder(softer, soft).find({Control::torque, 0.1});
  EXPECT_LT(point.result.speed, at_torque(0.1).result.speed - 0.5 * rpm);
}
