// SPDX-License-Identifier: LGPL-2.1-or-later

// Error bars of operating points, and what they lead to: the search for meshes, steps and modes, on
// synthetic motors whose errors are known.

#include "support/made_up_points.h"

#include <ringmotor/parameters/errors.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  CurvePoint point_at(const double torque, const std::vector<double> &asked_for, const double a,
                      const double b)
  {
    Search search(asked_for, 0.5, {a, b});
    for (const CurvePoint &point : search.find().points())
      if (point.request.value == torque)
        return point;
    throw std::runtime_error("the point is missing");
  }

  double speed_bar(const CurvePoint &point, const std::string &cause)
  {
    return point.errors.at(cause)["speed"];
  }
} // namespace

TEST(CurveErrorBars, OfOperatingPointsHoldTheirErrorsCauseByCause)
{
  constexpr double a = 0.2, b = 0.1, torque = 3., exact = 8. - torque;
  const CurvePoint point = point_at(torque, {torque}, a, b);
  // Level 1, and four parts, with which powers balance
  EXPECT_NEAR(point.result.speed, exact + a * 0.25 * (1. + torque) + b / 4., 1e-12);
  EXPECT_GE(speed_bar(point, "meshes of bodies and interface"), a * 0.25 * (1. + torque));
  EXPECT_LE(speed_bar(point, "meshes of bodies and interface"), 8. * a * 0.25 * (1. + torque));
  EXPECT_NEAR(speed_bar(point, "time step"), b / 4., 1e-12); // exact for an error of first order
  EXPECT_NEAR(speed_bar(point, "wave of the stator"), 1e-3 * exact, 1e-12);
  EXPECT_EQ(point.error()["torque"], 0.); // prescribed
}

TEST(CurveErrorBars, OfAnOperatingPointDoNotDependOnTheOthers)
{
  const CurvePoint alone = point_at(3., {3.}, 0.2, 0.1),
                   among = point_at(3., {0., 1., 3., 7.9}, 0.2, 0.1);
  EXPECT_EQ(alone.result.speed, among.result.speed);
  for (const auto &cause : all_error_causes())
    EXPECT_EQ(speed_bar(alone, cause->name), speed_bar(among, cause->name)) << cause->name;
}

TEST(CurveErrorBars, AlongACurveAreThoseOfTheMeasuredPointsOnBothSides)
{
  // A straight curve: ten torques, whose errors grow with them, and stall.
  constexpr double a = 0.02, b = 0.1;
  std::set<double> on_other_mesh;
  Search search(
      {}, 0.5,
      {a, b,
       [&](CurvePoint &point, const Discretisation &discretisation, const CondensedMotor &)
       {
         if (discretisation.level == 0)
           on_other_mesh.insert(point.result.torque);
       }});
  search.parameters.loading.n_curve_points = 11;
  const std::vector<CurvePoint> points     = search.find().points();
  ASSERT_EQ(points.size(), 11u);
  EXPECT_EQ(on_other_mesh.size(), 5u); // of four torques, and at stall
  const auto alone = [&](const unsigned int i)
  {
    const double torque = points[i].request.value;
    return point_at(torque, {torque}, a, b);
  };
  for (unsigned int i = 0; i < 10; ++i)
  {
    const CurvePoint before = alone(i / 3 * 3), after = alone((i + 2) / 3 * 3);
    for (const auto &cause : all_error_causes())
      EXPECT_NEAR(speed_bar(points[i], cause->name),
                  std::max(speed_bar(before, cause->name), speed_bar(after, cause->name)), 1e-12)
          << cause->name << " at point " << i;
    EXPECT_GE(speed_bar(points[i], causes::meshes), a * 0.25 * (1. + points[i].request.value));
  }
}

TEST(CurveErrorBars, ThatWouldMissTheTargetBetweenMeasuredPointsAreMeasured)
{
  // Below 3 N m the mesh matters, above 4.2 N m the wave: each within the target, of 0.32 rad/s,
  // both together not. Between them neither does.
  Search search(
      {}, 0.04,
      {0., 0.,
       [&](CurvePoint &point, const Discretisation &discretisation, const CondensedMotor &)
       {
         if (discretisation.level == 0 && point.result.torque < 3.)
           point.result.speed += 0.125;
         if (MadeUpPoints::variation_of(discretisation) == "larger wave" &&
             point.result.torque > 4.2)
           point.result.speed += 0.25;
       }});
  search.parameters.loading.n_curve_points = 11;
  const CurveSearch &found                 = search.find();
  EXPECT_EQ(found.discretisation().level, 1u);
  for (const CurvePoint &point : found.points())
  {
    const double torque = point.result.torque, bar = point.error()["speed"];
    if (torque > 3. && torque < 4.2)
    {
      EXPECT_LT(bar, 0.1) << torque;
    }
    else if (point.request.control == Control::torque)
    {
      EXPECT_GT(bar, 0.24) << torque;
    }
  }
}

TEST(CurveErrorBars, OfStepsFollowTheirLengths)
{
  // Powers at the second torque need steps half as long as at the first and the last one, whose
  // errors it takes: of first order in the steps. At the third, steps may be twice as long.
  constexpr double b   = 0.4;
  const auto parts_for = [](const CurvePoint &point)
  {
    const double torque = point.result.torque;
    return torque > 0.5 && torque < 1.2 ? 8u : torque > 1.2 && torque < 2. ? 2u : 4u;
  };
  Search search(
      {}, 0.5,
      {0., b, [&](CurvePoint &point, const Discretisation &discretisation, const CondensedMotor &) {
         point.result.tangential_loss =
             discretisation.steps.n_parts < parts_for(point) ? 0.49 : 0.5;
       }});
  search.parameters.loading.n_curve_points = 11;
  const std::vector<CurvePoint> points     = search.find().points();
  std::set<double> errors;
  for (unsigned int i = 0; i < 10; ++i)
  {
    const double error = points[i].result.speed - (8. - points[i].request.value);
    errors.insert(error);
    EXPECT_GE(speed_bar(points[i], causes::time_step), error - 1e-12) << i;
    EXPECT_LE(speed_bar(points[i], causes::time_step), 2. * error + 1e-12) << i;
  }
  EXPECT_GT(*errors.rbegin(), 3. * *errors.begin()); // steps do differ
}

TEST(CurveErrorBars, OfMeshesFollowTheLastChange)
{
  // Errors of the meshes 0 to 3.
  const auto mesh_bar =
      [](const std::array<double, 4> &errors, const double target, const unsigned int level)
  {
    Search search(
        {0.}, target,
        {0., 0.,
         [&errors](CurvePoint &point, const Discretisation &discretisation, const CondensedMotor &)
         {
           if (point.request.control == Control::torque)
             point.result.speed += errors[discretisation.level];
         }});
    const CurveSearch &found = search.find();
    EXPECT_EQ(found.discretisation().level, level);
    return speed_bar(found.points().front(), "meshes of bodies and interface");
  };
  const std::array<double, 4> regular{{0.36, 0.12, 0.04, 0.01}};
  EXPECT_NEAR(mesh_bar(regular, 0.1, 1), 2. * 0.24, 1e-12);
  EXPECT_NEAR(mesh_bar(regular, 0.02, 2), 0.75 * 0.08, 1e-12);
  EXPECT_NEAR(mesh_bar(regular, 0.004, 3), 0.75 * 0.03, 1e-12);
  // A last change that happens to be small is not trusted: a quarter of the one before.
  EXPECT_NEAR(mesh_bar({{0.36, 0.12, 0.12, 0.}}, 0.02, 2), 0.75 * 0.06, 1e-12);
  // Values that swing about their limit
  EXPECT_NEAR(mesh_bar({{0.2, -0.1, 0.03, -0.01}}, 0.025, 2), 0.75 * 0.13, 1e-12);
}

TEST(CurveErrorBars, OfMeshesAreLargerWhereFewTeethTouch)
{
  // All meshes agree by chance: in proportion to 3 over the teeth per wave, down to one tooth.
  for (const auto &[teeth, factor] : {std::pair(6., 1.), {3., 1.}, {1.5, 2.}, {0.1, 3.}})
  {
    const double number = teeth;
    Search search({3.}, 0.5,
                  {0., 0.,
                   [number](CurvePoint &point, const Discretisation &, const CondensedMotor &)
                   {
                     point.result.teeth_in_contact = number;
                     point.result.tangential_loss  = 0.5;
                   }});
    const PointError &bars = search.find().points().front().errors.at(causes::meshes);
    EXPECT_NEAR(bars["stick_fraction"], factor * 0.06, 1e-12) << teeth;
    EXPECT_NEAR(bars["friction_loss"], factor * 0.02 * 0.5, 1e-12) << teeth;
  }
}

TEST(CurveErrorBars, OfMeshesContainTheLossThatAnErrorOfSpeedBrings)
{
  // The loss is the same on all meshes; speeds are not, and what torque times speed lacks is lost.
  const PointError bars = point_at(3., {3.}, 0.2, 0.1).errors.at(causes::meshes);
  EXPECT_GT(bars["speed"], 0.05);
  EXPECT_NEAR(bars["friction_loss"], 3. * bars["speed"], 1e-12);
}

TEST(CurveErrorBars, AreAtLeastWhatCountingResolves)
{
  // Teeth and sticking nodes are counted, here alike on all meshes and with all steps: a contact of
  // a tooth is known to a step, the share of force on nodes that stick to that of one node.
  Search search({3.}, 0.5,
                {0.2, 0.1, [](CurvePoint &point, const Discretisation &, const CondensedMotor &) {
                   point.largest_share = 0.5;
                 }});
  const PointError &bars = search.find().points().front().errors.at("time step");
  EXPECT_NEAR(bars["stick_fraction"], 0.5, 1e-12);
  EXPECT_NEAR(bars["teeth_in_contact_per_wave"], 90. / 7. * 1e-7 / period, 1e-12);
}

TEST(CurveErrorBars, HaveTheAveragingWindowOfTheMeshThatIsShown)
{
  // A window misses 0.02, and settled means are still off by 0.01.
  std::multiset<unsigned int> levels; // on which means had to settle
  Search search(
      {1., 2.}, 0.1,
      {0.2, 0.1,
       [&levels](CurvePoint &point, const Discretisation &discretisation, const CondensedMotor &)
       {
         if (MadeUpPoints::variation_of(discretisation) != "settled means")
           return;
         levels.insert(discretisation.level);
         point.result.speed += 0.02;
         point.unsettled_means["speed"] = 0.01;
       }});
  search.parameters.time.scheme            = TimeScheme::marching;
  search.parameters.time.n_steps           = 15;
  search.parameters.time.average_from_step = 6;
  search.parameters.time.average_to_step   = 15;
  search.parameters.accuracy.mode          = AccuracyMode::fixed;
  for (const CurvePoint &point : search.find().points())
    EXPECT_NEAR(speed_bar(point, "averaging window"), 0.03, 1e-12);
  EXPECT_EQ(levels.count(0), 2u);
  EXPECT_EQ(levels.count(1), 0u);
}

TEST(CurveErrorBars, LeadToFinerModesWhereTheseMatterMost)
{
  // Errors of c, c/3 and c/9 at three levels of modes.
  for (const auto &[c, level] : {std::pair(1., 1u), std::pair(3., 2u)})
  {
    Search search({3.}, 0.1,
                  {0.02, 0.,
                   [error = c](CurvePoint &point, const Discretisation &discretisation,
                               const CondensedMotor &motor)
                   {
                     const std::string variation = MadeUpPoints::variation_of(discretisation);
                     const bool is_coarse =
                         variation == "coarse modes" || variation == "modes of other harmonics";
                     if (point.request.control == Control::torque)
                       point.result.speed +=
                           error / std::pow(3., motor.modes_level - (is_coarse ? 1. : 0.));
                   }});
    search.source.vibrates   = true;
    const CurveSearch &found = search.find();
    EXPECT_EQ(found.motor().modes_level, level);
    const double bar = speed_bar(found.points().front(), "modes of rotor and teeth");
    EXPECT_NEAR(bar, 0.6 * c * (std::pow(3., 1. - level) - std::pow(3., -1. * level)), 1e-12);
    EXPECT_GT(bar, c * std::pow(3., -1. * level));
  }
}

TEST(CurveErrorBars, AreNotSoughtWhereNoStepBalancesThePowers)
{
  // Powers that leave a share of the loss which hardly depends on the step (order 0.05), or falls
  // with it (order 1).
  const auto find = [](const double order)
  {
    Search({0.}, 0.1,
           {0., 0.,
            [=](CurvePoint &point, const Discretisation &discretisation, const CondensedMotor &) {
              point.result.input_power *=
                  1. + 0.04 * std::pow(discretisation.steps.n_parts, -order);
            }})
        .find();
  };
  EXPECT_NO_THROW(find(1.));
  try
  {
    find(0.05);
    ADD_FAILURE() << "an imbalance that remains was accepted";
  }
  catch (const ComputationError &error)
  {
    EXPECT_NE(std::string(error.what()).find("no steps short enough"), std::string::npos)
        << error.what();
  }
}

TEST(CurveErrorBars, AreHeldForTheListedQuantities)
{
  // Losses and speeds have the relative errors 0.16 and 0.016 on mesh 0, half of them on the next.
  const auto level_for =
      [](const std::vector<QuantityTarget> &quantities, const double contact_target)
  {
    Search search(
        {0.}, contact_target,
        {0., 0.,
         [](CurvePoint &point, const Discretisation &discretisation, const CondensedMotor &)
         {
           const double error = 0.16 * std::pow(0.5, discretisation.level);
           if (point.request.control == Control::torque)
             point.result.speed *= 1. + 0.1 * error;
           point.result.radial_loss = error * point.result.tangential_loss;
           point.result.input_power = // powers balance
               point.result.output_work + point.result.friction_loss();
         }});
    search.parameters.accuracy.quantities = quantities;
    const CurveSearch &found              = search.find();
    for (const QuantityTarget &held : quantities)
    {
      const CurvePoint &point = found.points().front();
      const PointError total  = point.error();
      EXPECT_LE(total[held.quantity] / quantity_named(held.quantity).value(point),
                held.target.value_or(contact_target));
    }
    return found.discretisation().level;
  };
  const std::string speed = "speed", loss = "friction_loss";
  EXPECT_EQ(level_for({{speed, {}}}, 0.04), 1u);
  EXPECT_EQ(level_for({{loss, {}}}, 0.06), 2u);
  EXPECT_EQ(level_for({{speed, {}}, {loss, 0.02}}, 0.1), 3u);
  EXPECT_EQ(level_for({{speed, {}}, {loss, 0.06}}, 0.04), 2u);
  EXPECT_EQ(level_for({{loss, 0.3}, {speed, {}}}, 0.04), 1u);
}

TEST(CurveErrorBars, LeadToSettingsThatCanBeFrozen)
{
  Search search({1., 3.}, 0.05, {0.2, 0.1});
  const CurveSearch &found = search.find();
  Search frozen({1., 3.}, 0.05, {0.2, 0.1});
  frozen.parameters = found.frozen();
  EXPECT_EQ(frozen.parameters.accuracy.mode, AccuracyMode::fixed);
  EXPECT_EQ(frozen.parameters.accuracy.interface_refinement, found.discretisation().level);
  const CurveSearch &again = frozen.find();
  EXPECT_EQ(again.discretisation().level, found.discretisation().level);
  for (unsigned int i = 0; i < found.points().size(); ++i)
    EXPECT_EQ(again.points()[i].result.speed, found.points()[i].result.speed) << i;
}

TEST(StepChoice, BeginsWithLongStepsAndComparesWithThoseOfTwiceTheLength)
{
  // Ninety different teeth: ninety undivided steps in a period; a target of 1 % asks for 120.
  Parameters parameters          = paper_motor();
  parameters.initial_deformation = {};
  const auto choice              = [&](const double target)
  {
    parameters.accuracy.contact_target = target;
    return StepChoice(parameters, period);
  };
  EXPECT_EQ(choice(0.01).plain(), (Steps{2}));
  EXPECT_EQ(choice(0.01).longest(), (Steps{1}));
  EXPECT_EQ(choice(0.01).first_parts(), 2u);
  EXPECT_EQ(choice(0.01).plain().doubled(), (Steps{1}));
  EXPECT_EQ(choice(0.003).plain(), (Steps{4}));
  EXPECT_EQ(choice(0.003).longest(), (Steps{1}));
  EXPECT_EQ(choice(0.1).plain(), (Steps{1, 2}));
  EXPECT_EQ(choice(0.1).longest(), choice(0.1).plain());
  EXPECT_EQ(choice(0.1).first_parts(), 1u);
}
