// SPDX-License-Identifier: LGPL-2.1-or-later

// Marched operating points. The period of the solution against a search over all rotations of the
// ring; the reference motor with a warp of 4 um at 78 rpm against an independent model (its own
// meshes, its own contact; one coefficient 0.40), which gave 56 mN m as the mean over whole
// periods, 26 with a step from tooth to tooth instead of a slope, and 117 without a warp; error
// bars against the same motor marched three times as long.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/marched_point.h>
#include <ringmotor/points/mesh_transfer.h>
#include <ringmotor/points/point_finder.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double rpm = M_PI / 30.;

  /** Tries all rotations that map the warp onto itself and returns the smallest lag of the wave, in
   * N-th parts of a period. */
  unsigned int parts_by_trial(const RingPattern &pattern)
  {
    unsigned int smallest = pattern.n_teeth;
    for (unsigned int turn = 1; turn <= pattern.n_teeth; ++turn)
      if (turn * pattern.warp_waves % pattern.n_teeth == 0)
        if (const unsigned int lag = turn * pattern.n_waves % pattern.n_teeth; lag > 0)
          smallest = std::min(smallest, lag);
    return pattern.n_teeth / smallest;
  }

  double sum_of(const std::vector<PointVector> &forces, const std::size_t first,
                const std::size_t n_forces, const unsigned int component)
  {
    double sum = 0.;
    for (std::size_t i = first; i < first + n_forces; ++i)
      sum += forces[i][component];
    return sum;
  }
} // namespace

TEST(MarchedPeriod, IsTheShortestThatATurnMakes)
{
  EXPECT_EQ(repetition_of({7, 90, 0}).n_parts, 90u); // by hand: an even ring, n and N coprime
  EXPECT_EQ(repetition_of({9, 90, 0}).n_parts, 10u);
  EXPECT_EQ(repetition_of({7, 90, 2}).n_parts, 2u); // the warp is the same after half a turn
  EXPECT_EQ(repetition_of({7, 45, 2}).n_parts, 1u); // half a turn is not a whole number of teeth
  for (unsigned int n_teeth = 3; n_teeth <= 48; ++n_teeth)
    for (unsigned int n_waves = 1; 2 * n_waves < n_teeth; ++n_waves)
      for (unsigned int warp_waves = 0; warp_waves <= 9; ++warp_waves)
      {
        const RingPattern pattern{n_waves, n_teeth, warp_waves};
        const auto [n_parts, turn] = repetition_of(pattern);
        EXPECT_EQ(n_parts, parts_by_trial(pattern))
            << n_waves << " " << n_teeth << " " << warp_waves;
        // The rotation leaves the warp unchanged, and the wave arrives one part later.
        EXPECT_EQ(turn * warp_waves % n_teeth, 0u);
        EXPECT_EQ(n_parts * (turn * n_waves % n_teeth) % n_teeth, 0u);
        EXPECT_EQ(turn * n_waves % n_teeth, n_teeth / n_parts % n_teeth);
      }
}

namespace
{
  class WarpedMotor : public testing::Test
  {
  protected:
    static void SetUpTestSuite()
    {
      parameters                               = reference_motor();
      parameters.initial_deformation.amplitude = 4e-6;
      const StatorWave wave                    = stator_wave(parameters);
      motor  = condense_motor(parameters, wave, ContactDiscretisation::level(1));
      coarse = condense_motor(parameters, wave, ContactDiscretisation::level(0));
    }

    static Parameters parameters;
    static CondensedMotor motor, coarse; ///< interface meshes 1 and 0
  };
  Parameters WarpedMotor::parameters = paper_motor();
  CondensedMotor WarpedMotor::motor, WarpedMotor::coarse;
} // namespace

TEST_F(WarpedMotor, StandsUpByAFieldOfHeights)
{
  const Warp warp{4e-6, 2};
  const TimeStep step{1e-5, 1e-6, {}};
  const RingContact even(motor, {14., {}}, step, Warp()), warped(motor, {14., {}}, step, warp);
  for (unsigned int point = 0; point < warped.n_points(); ++point)
  {
    const double theta     = 2. * M_PI / 90. * warped.tooth(point) + warped.node(point).angle;
    const PointVector rise = warped.free_motion(point) - even.free_motion(point);
    EXPECT_NEAR(rise[0], 4e-6 * std::cos(2. * theta), 1e-18);
    EXPECT_EQ(rise[1], 0.);
    EXPECT_EQ(rise[2], 0.);
  }
  // A uniform height is no warp.
  Parameters raised                  = parameters;
  raised.initial_deformation.n_waves = 0;
  EXPECT_EQ(repetition_of({7, 90, 0}).n_parts,
            repetition_of({7, 90, motor_model(raised).warp.n_waves}).n_parts);
  const double lifted = find_marched(raised, coarse, {Control::speed, 70. * rpm}).result.torque;
  raised.initial_deformation.amplitude = 0.;
  EXPECT_NEAR(lifted, find_marched(raised, coarse, {Control::speed, 70. * rpm}).result.torque,
              1e-6 * lifted);
}

TEST_F(WarpedMotor, MovesTurnedAsTurnedForcesMoveIt)
{
  const RingContact contact(coarse, {14., {}}, TimeStep{0., 1e-6, {}}, Warp());
  StepEnd end;
  end.state = {std::vector<PointVector>(contact.n_points()),
               std::vector<double>(contact.n_rigid_motions())};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1., 1.);
  for (unsigned int point = 0; point < contact.n_points(); point += 3)
    for (unsigned int c = 0; c < 3; ++c)
      end.state.force[point][c] = any(random);
  for (double &motion : end.state.rigid)
    motion = 1e-6 * any(random);
  ASSERT_GE(end.state.rigid.size(), 3u) << "a tilt must turn, too";
  end.motion     = contact.motion_by(end.state);
  double largest = 0.;
  for (const PointVector &motion : end.motion)
    largest = std::max(largest, motion.norm());
  for (const unsigned int by : {0u, 1u, 13u, 89u})
  {
    const StepEnd other                   = turned(end, by, 90);
    const std::vector<PointVector> motion = contact.motion_by(other.state);
    for (unsigned int point = 0; point < contact.n_points(); ++point)
      EXPECT_LT((motion[point] - other.motion[point]).norm(), 1e-12 * largest) << by;
  }
}

TEST_F(WarpedMotor, IsForeseenOnceItHasSettled)
{
  // On an even ring the state repeats after T/90, on a warped one after T/2, whatever the previous
  // steps.
  for (const Warp &warp : {Warp(), Warp{4e-6, 2}})
    for (const double steps : {90., 40., 33.})
    {
      MarchingDriver driver(coarse, parameters.friction, warp, 14.);
      StepHistory history(coarse, warp);
      const double length = coarse.period() / steps;
      double missed = 0., all = 0.; // squares of forces, in the last of six periods
      for (unsigned int step = 0; step < 6. * steps; ++step)
      {
        const OperatingState state = driver.step({14., {}, 70. * rpm}, length);
        const StepEnd end{state.solution, driver.time(), length};
        if (step >= 5. * steps)
        {
          const StepEnd &foreseen = history.predict(length);
          for (unsigned int point = 0; point < end.motion.size(); ++point)
          {
            missed += (foreseen.state.force[point] - end.state.force[point]).norm_square();
            all += end.state.force[point].norm_square();
          }
        }
        else if (step > 0)
          history.predict(length); // from which the next one learns
        history.add(end);
      }
      const double error = std::sqrt(missed / all);
      record("relative error of the forces, 90, 40, 33 steps per period, warp of " +
                 std::to_string(warp.n_waves) + " waves",
             error);
      EXPECT_LT(error, 1e-6);
    }
}

TEST_F(WarpedMotor, HasTheTorqueOfAnIndependentModel)
{
  // The model's numbers are from a mesh on which its speeds without a warp are those of interface
  // mesh 0. Finer meshes, ours and the model's, lower both torques by some mN m at this speed,
  // where the curve is flat, and barely change the effect of the warp.
  Parameters even                    = parameters;
  even.initial_deformation.amplitude = 0.;
  const PointRequest request{Control::speed, 78. * rpm};
  for (const CondensedMotor *mesh : {&coarse, &motor})
  {
    const CurvePoint point = find_marched(parameters, *mesh, request);
    const double flat      = OperatingPointFinder(even, *mesh).find(request).result.torque;
    const std::string on   = ", " + std::to_string(mesh->nodes.size()) + " contact nodes";
    record("torque, with and without the warp (mN m)" + on, 1e3 * point.result.torque);
    record("torque, with and without the warp (mN m)" + on, 1e3 * flat);
    record("error bar of the averaging window (mN m)" + on, 1e3 * point.unsettled_means["torque"]);
    EXPECT_NEAR(1e3 * (flat - point.result.torque), 117. - 56., 0.15 * 56.);
    EXPECT_LE(point.unsettled_means["torque"], 0.1 * parameters.accuracy.contact_target * 0.2);
    EXPECT_LE(point.largest_violation, ContactCertificate::limit);
    if (mesh == &coarse)
    {
      EXPECT_NEAR(1e3 * point.result.torque, 56., 0.15 * 56.);
    }
  }
}

TEST_F(WarpedMotor, IsTheSameHalfAPeriodLaterAndHalfATurnOn)
{
  MarchedRun run(parameters, coarse, {Control::speed, 70. * rpm});
  constexpr unsigned int n_steps = 34;
  const double step              = 0.5 * coarse.period() / n_steps;
  run.advance(6 * n_steps, step);
  const ContactFields first = run.advance(n_steps, step).fields,
                      next  = run.advance(n_steps, step).fields;
  const std::size_t n_nodes = coarse.nodes.size();
  double largest = 0., worst = 0.;
  for (unsigned int sample = 0; sample < n_steps; ++sample)
    for (unsigned int tooth = 0; tooth < 90; ++tooth)
    {
      const double force = sum_of(first.state.force, (sample * 90 + tooth) * n_nodes, n_nodes, 1),
                   later = sum_of(next.state.force, (sample * 90 + (tooth + 45) % 90) * n_nodes,
                                  n_nodes, 1);
      largest            = std::max(largest, std::abs(force));
      worst              = std::max(worst, std::abs(force - later));
    }
  record("largest difference over the largest force", worst / largest);
  EXPECT_LT(worst, 1e-6 * largest);
}

TEST_F(WarpedMotor, StepsAreShortenedToFillThePeriod)
{
  const CurvePoint point = find_marched(parameters, coarse, {Control::speed, 60. * rpm});
  const double n_steps   = 0.5 * coarse.period() / point.fields.time_step;
  EXPECT_NEAR(n_steps, 34., 1e-9); // of 0.5 us at most
  EXPECT_EQ(point.fields.times.size(), 34u) << "the last period of the solution, and no more";
  const CurvePoint halves =
      find_marched(with_parts_of_a_step(parameters, 2), coarse, {Control::speed, 60. * rpm});
  EXPECT_NEAR(point.fields.time_step / halves.fields.time_step, 2., 1e-9);
}

TEST_F(WarpedMotor, JoinsStepsAsIfTheyHadBeenLonger)
{
  const PointRequest request{Control::speed, 60. * rpm};
  const double step        = 5e-7;
  const MarchedSpan joined = MarchedRun(parameters, coarse, request, 2).advance(34, step),
                    longer = MarchedRun(parameters, coarse, request).advance(17, 2. * step);
  EXPECT_NEAR(joined.fields.times.back(), 34. * step, 1e-15);
  EXPECT_NEAR(joined.mean.torque, longer.mean.torque, 1e-12 * longer.mean.torque);

  Parameters window             = parameters;
  window.time.n_steps           = 15;
  window.time.average_from_step = 7;
  window.time.average_to_step   = 13;
  const CurvePoint averaged     = find_marched(window, coarse, request, 2);
  // Steps 1, 2-3, 4-5, 6, then 7-8, 9-10, 11-12, 13, then 14-15
  const std::vector<double> n_ends{1., 3., 5., 6., 8., 10., 12., 13., 15.};
  ASSERT_EQ(averaged.fields.times.size(), n_ends.size());
  for (unsigned int i = 0; i < n_ends.size(); ++i)
    EXPECT_NEAR(averaged.fields.times[i] / window.time.time_step, n_ends[i], 1e-9) << i;
}

TEST(MeanOfSteps, IsOverTheirTime)
{
  OperatingPoint first, second;
  first.torque  = 1.;
  second.torque = 5.;
  EXPECT_DOUBLE_EQ(mean({first, second}, {3e-7, 1e-7}).torque, 2.); // by hand
}

TEST_F(WarpedMotor, AveragesOverTheWindowOfThePaper)
{
  Parameters window             = parameters;
  window.time.n_steps           = 15;
  window.time.average_from_step = 6;
  window.time.average_to_step   = 15;
  const PointRequest request{Control::speed, 70. * rpm};
  const CurvePoint point   = find_marched(window, coarse, request),
                   settled = find_marched(parameters, coarse, request);
  record("torque, of the window and settled (mN m)", 1e3 * point.result.torque);
  record("torque, of the window and settled (mN m)", 1e3 * settled.result.torque);
  EXPECT_EQ(point.fields.times.size(), 15u);
  EXPECT_DOUBLE_EQ(point.fields.times.back(), 7.5e-6);
  EXPECT_GT(std::abs(point.result.torque - settled.result.torque),
            settled.unsettled_means["torque"]);
}

TEST_F(WarpedMotor, IsTheSameFromTheStateOfAnotherPointOrMesh)
{
  const PointRequest request{Control::torque, 0.05}, other{Control::torque, 0.};
  const CurvePoint alone = find_marched(parameters, coarse, request),
                   after = find_marched(parameters, coarse, other);
  ASSERT_TRUE(after.end.is_known());
  const CurvePoint next        = find_marched(parameters, coarse, request, 1, &after);
  CurvePoint moved             = after;
  const CurvePoint finer       = find_marched(parameters, motor, request);
  moved.end                    = MeshTransfer(coarse, motor).marched(after.end);
  const CurvePoint from_coarse = find_marched(parameters, motor, request, 1, &moved);
  // Far apart, so that it matters
  ASSERT_GT(std::abs(after.result.speed - alone.result.speed), 1e-2 * alone.result.speed);
  EXPECT_NEAR(next.result.speed, alone.result.speed, 1e-3 * alone.result.speed);
  EXPECT_NEAR(next.result.friction_loss(), alone.result.friction_loss(),
              1e-3 * alone.result.friction_loss());
  EXPECT_NEAR(from_coarse.result.speed, finer.result.speed, 1e-3 * finer.result.speed);
}

TEST_F(WarpedMotor, SaysThatItDoesNotSettle)
{
  Parameters hopeless              = parameters;
  hopeless.accuracy.contact_target = -1.; // nothing is below it
  hopeless.time.time_step          = 4e-6;
  try
  {
    find_marched(hopeless, coarse, {Control::speed, 70. * rpm});
    FAIL() << "settled";
  }
  catch (const ComputationError &error)
  {
    const std::string said = error.what();
    for (const std::string word :
         {"does not settle at ", " rpm: ", "torques from", "friction losses from",
          "choose a larger Accuracy/Contact target"})
      EXPECT_NE(said.find(word), std::string::npos) << said;
  }
}

class WarpedMotorLong : public WarpedMotor
{
};

TEST_F(WarpedMotorLong, BarsHoldARunOfThreeTimesTheLength)
{
  for (const double speed : {60., 70., 78., 83.})
  {
    const PointRequest request{Control::speed, speed * rpm};
    const CurvePoint point = find_marched(parameters, coarse, request);
    const double step = point.fields.time_step, end = point.fields.times.back();
    const auto n_spans = static_cast<unsigned int>(std::lround(end / (34. * step)));
    MarchedRun run(parameters, coarse, request);
    run.advance(1, step);
    run.advance((3 * n_spans - 1) * 34, step);
    const OperatingPoint later = run.advance(34, step).mean;
    record("torque at 60, 70, 78, 83 rpm (mN m)", 1e3 * point.result.torque);
    record("error bar of the averaging window (mN m)", 1e3 * point.unsettled_means["torque"]);
    record("actual error of the torque (mN m)", 1e3 * (point.result.torque - later.torque));
    record("half periods marched", n_spans);
    EXPECT_NEAR(point.result.torque, later.torque, point.unsettled_means["torque"]) << speed;
    EXPECT_NEAR(point.result.friction_loss(), later.friction_loss(),
                point.unsettled_means["friction_loss"])
        << speed;
    EXPECT_LE(point.unsettled_means["torque"], 0.1 * parameters.accuracy.contact_target * 0.2)
        << speed;
  }
}

TEST_F(WarpedMotorLong, TurnsAsFastAsItsTorqueAsks)
{
  const CurvePoint point = find_marched(parameters, coarse, {Control::torque, 0.05});
  EXPECT_NEAR(point.result.torque, 0.05, 1e-9);
  const CurvePoint driven = find_marched(parameters, coarse, {Control::speed, point.result.speed});
  record("speed (rpm)", point.result.speed / rpm);
  record("torque at a given speed (mN m)", 1e3 * driven.result.torque);
  // A different case: there the speed varies within a period, here the torque does.
  EXPECT_NEAR(driven.result.torque, 0.05, 0.15 * 0.05);
}
