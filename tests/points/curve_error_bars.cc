// SPDX-License-Identifier: LGPL-2.1-or-later

// Error bars of operating points, and what they lead to: the search for meshes, steps and modes, on
// synthetic motors whose errors are known.

#include "support/paper_motor.h"
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/curve_search.h>
#include <ringmotor/points/point_quantities.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double window_error = 0.01; // rad/s, of synthetic points that report it
  constexpr double period       = 1e-5 * dealii::numbers::PI; // s, of the synthetic wave

  /** Synthetic sources of points: speeds w0 - T with a mesh error a / 4^level, a time step error
   * b/n for n parts, and an error in proportion to the wave; powers balance with four parts. */
  CurveSearch::Sources made_up_sources(const double a, const double b)
  {
    CurveSearch::Sources sources;
    sources.motors = [](const std::vector<unsigned int> &levels, unsigned int)
    {
      CondensedMotor motor;
      motor.n_teeth           = 90;
      motor.n_waves           = 7;
      motor.angular_frequency = 2. * dealii::numbers::PI / period;
      motor.amplitude         = 2e-6;
      motor.nodes  = {{1., 0., 1., {}}, {2., 0., 1., {}}, {1., 0.1, 1., {}}, {2., 0.1, 1., {}}};
      motor.faces  = {{0, 1, 2, 3}};
      motor.degree = 1;
      return std::vector<TimedMotor>(levels.size(), {motor, 0.});
    };
    sources.points = [a, b](const Parameters &, const CondensedMotor &, const CurveSetting &setting,
                            const std::vector<PointRequest> &requests,
                            const std::vector<CurvePoint> &)
    {
      std::vector<CurvePoint> points;
      for (const PointRequest &request : requests)
      {
        CurvePoint point;
        point.request        = request;
        const bool of_torque = request.control == Control::torque;
        point.result.torque  = of_torque ? request.value : 8.;
        const double exact   = (8. - point.result.torque) * setting.wave_factor;
        point.result.speed =
            of_torque ? exact + a * std::pow(0.25, setting.level) * (1. + point.result.torque) +
                            b * setting.n_joined / setting.n_parts
                      : request.value;
        point.result.amplitude       = 2e-6;
        point.result.input_power     = 1.;
        point.result.gross_power     = 1.;
        point.result.output_work     = 0.5;
        point.result.tangential_loss = setting.n_parts < 4 ? 0.49 : 0.5;
        point.fields.time_step       = 1e-7;
        point.tells_window           = setting.tells_window;
        point.window["speed"]        = setting.tells_window ? window_error : 0.;
        points.push_back(point);
      }
      return points;
    };
    return sources;
  }

  CurvePoint point_at(const double torque, const std::vector<double> &asked_for, const double a,
                      const double b)
  {
    Parameters parameters              = paper_motor();
    parameters.loading.values          = asked_for;
    parameters.loading.control         = Control::torque;
    parameters.initial_deformation     = {};
    parameters.accuracy.contact_target = 0.5;
    CurveSearch search(parameters, 1e-3, period, made_up_sources(a, b));
    search.find();
    for (const CurvePoint &point : search.points())
      if (point.request.value == torque)
        return point;
    throw std::runtime_error("the point is missing");
  }
} // namespace

TEST(CurveErrorBars, OfOperatingPointsHoldTheirErrorsCauseByCause)
{
  constexpr double a = 0.2, b = 0.1, torque = 3., exact = 8. - torque;
  const CurvePoint point = point_at(torque, {torque}, a, b);
  const auto bar         = [&](const char *const cause) { return point.errors.at(cause)["speed"]; };
  // Level 1, and four parts, with which powers balance
  EXPECT_NEAR(point.result.speed, exact + a * 0.25 * (1. + torque) + b / 4., 1e-12);
  EXPECT_GE(bar(causes::meshes), a * 0.25 * (1. + torque));
  EXPECT_LE(bar(causes::meshes), 8. * a * 0.25 * (1. + torque));
  EXPECT_NEAR(bar(causes::time_step), b / 4., 1e-12); // exact for an error of first order
  EXPECT_NEAR(bar(causes::wave), 1e-3 * exact, 1e-12);
  EXPECT_EQ(point.error()["torque"], 0.); // prescribed
}

TEST(CurveErrorBars, OfAnOperatingPointDoNotDependOnTheOthers)
{
  const CurvePoint alone = point_at(3., {3.}, 0.2, 0.1),
                   among = point_at(3., {0., 1., 3., 7.9}, 0.2, 0.1);
  EXPECT_EQ(alone.result.speed, among.result.speed);
  for (const char *const cause : causes::all)
    EXPECT_EQ(alone.errors.at(cause)["speed"], among.errors.at(cause)["speed"]) << cause;
}

TEST(CurveErrorBars, OfMeshesFollowTheLastChange)
{
  // Errors of the meshes 0 to 3.
  const auto mesh_bar =
      [](const std::array<double, 4> &errors, const double target, const unsigned int level)
  {
    Parameters parameters              = paper_motor();
    parameters.loading.values          = {0.}; // torque
    parameters.initial_deformation     = {};
    parameters.accuracy.contact_target = target;
    CurveSearch::Sources sources       = made_up_sources(0., 0.);
    sources.points                     = [&errors, exact = sources.points](
                         const Parameters &all, const CondensedMotor &motor,
                         const CurveSetting &setting, const std::vector<PointRequest> &requests,
                         const std::vector<CurvePoint> &starts)
    {
      std::vector<CurvePoint> points = exact(all, motor, setting, requests, starts);
      for (CurvePoint &point : points)
        if (point.request.control == Control::torque)
          point.result.speed += errors[setting.level];
      return points;
    };
    CurveSearch search(parameters, 1e-4, period, sources);
    search.find();
    EXPECT_EQ(search.level(), level);
    return search.points().front().errors.at(causes::meshes)["speed"];
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

TEST(CurveErrorBars, AreAtLeastWhatCountingResolves)
{
  // Teeth and sticking nodes are counted, here alike on all meshes and with all steps: a contact of
  // a tooth is known to a step, the share of force on nodes that stick to that of one node.
  Parameters parameters              = paper_motor();
  parameters.loading.values          = {3.};
  parameters.loading.control         = Control::torque;
  parameters.initial_deformation     = {};
  parameters.accuracy.contact_target = 0.5;
  CurveSearch::Sources sources       = made_up_sources(0.2, 0.1);
  sources.points = [points = sources.points](const Parameters &all, const CondensedMotor &motor,
                                             const CurveSetting &setting,
                                             const std::vector<PointRequest> &requests,
                                             const std::vector<CurvePoint> &starts)
  {
    std::vector<CurvePoint> found = points(all, motor, setting, requests, starts);
    if (setting.n_parts == 1) // would have to be transferred from mesh to mesh
      return found;
    for (CurvePoint &point : found)
      for (const double pressure : {3., 1., 0., 4.})
      {
        point.fields.force.emplace_back();
        point.fields.force.back()[0] = pressure;
      }
    return found;
  };
  CurveSearch search(parameters, 1e-3, period, sources);
  search.find();
  const PointError &bars = search.points().front().errors.at(causes::time_step);
  EXPECT_NEAR(bars["stick_fraction"], 0.5, 1e-12);
  EXPECT_NEAR(bars["teeth_in_contact_per_wave"], 90. / 7. * 1e-7 / period, 1e-12);
}

TEST(CurveErrorBars, HaveTheAveragingWindowOfTheMeshThatIsShown)
{
  Parameters parameters             = paper_motor();
  parameters.loading.values         = {1., 2.};
  parameters.loading.control        = Control::torque;
  parameters.time.scheme            = TimeScheme::marching;
  parameters.time.n_steps           = 15;
  parameters.time.average_from_step = 6;
  parameters.time.average_to_step   = 15;
  parameters.accuracy.mode          = AccuracyMode::fixed;
  CurveSearch::Sources sources      = made_up_sources(0.2, 0.1);
  std::multiset<unsigned int> levels; // of points that had to report it
  sources.points = [&levels, points = sources.points](
                       const Parameters &all, const CondensedMotor &motor,
                       const CurveSetting &setting, const std::vector<PointRequest> &requests,
                       const std::vector<CurvePoint> &starts)
  {
    if (setting.tells_window)
      for (unsigned int i = 0; i < requests.size(); ++i)
        levels.insert(setting.level);
    return points(all, motor, setting, requests, starts);
  };
  CurveSearch search(parameters, 1e-3, period, sources);
  search.find();
  for (const CurvePoint &point : search.points())
    EXPECT_EQ(point.errors.at(causes::window)["speed"], window_error);
  EXPECT_EQ(levels.count(0), 3u); // including stall, by which the curve is judged
  EXPECT_EQ(levels.count(1), 0u);
}

TEST(CurveErrorBars, LeadToFinerModesWhereTheseMatterMost)
{
  // Errors of c, c/3 and c/9 at three levels of modes.
  Parameters parameters              = paper_motor();
  parameters.loading.values          = {3.};
  parameters.loading.control         = Control::torque;
  parameters.initial_deformation     = {};
  parameters.accuracy.contact_target = 0.1;
  for (const auto &[c, level] : {std::pair(1., 1u), std::pair(3., 2u)})
  {
    CurveSearch::Sources sources = made_up_sources(0.02, 0.);
    sources.motors =
        [of_all = sources.motors](const std::vector<unsigned int> &levels, const unsigned int modes)
    {
      std::vector<TimedMotor> motors = of_all(levels, modes);
      for (TimedMotor &timed : motors)
      {
        timed.motor.modes_level = modes;
        timed.motor.modes       = {{{1e5, {}}}};
      }
      return motors;
    };
    sources.points = [error = c, of_all = sources.points](
                         const Parameters &all, const CondensedMotor &motor,
                         const CurveSetting &setting, const std::vector<PointRequest> &requests,
                         const std::vector<CurvePoint> &starts)
    {
      std::vector<CurvePoint> points = of_all(all, motor, setting, requests, starts);
      const unsigned int modes_in_use =
          motor.modes_level - (setting.modes == ModesInUse::requested ? 0 : 1);
      for (CurvePoint &point : points)
        if (point.request.control == Control::torque)
          point.result.speed += error / std::pow(3., modes_in_use);
      return points;
    };
    CurveSearch search(parameters, 1e-3, period, sources);
    search.find();
    EXPECT_EQ(search.motor().modes_level, level);
    const PointError &bars = search.points().front().errors.at(causes::modes);
    EXPECT_NEAR(bars["speed"], 0.6 * c * (std::pow(3., 1. - level) - std::pow(3., -1. * level)),
                1e-12);
    EXPECT_GT(bars["speed"], c * std::pow(3., -1. * level));
  }
}

TEST(CurveErrorBars, AreNotSoughtWhereNoStepBalancesThePowers)
{
  // Powers that leave a share of the loss which hardly depends on the step (order 0.05), or falls
  // with it (order 1).
  const auto find = [](const double order)
  {
    Parameters parameters          = paper_motor();
    parameters.loading.values      = {0.}; // torque
    parameters.initial_deformation = {};
    CurveSearch::Sources sources   = made_up_sources(0., 0.);
    sources.points = [=, exact = sources.points](const Parameters &all, const CondensedMotor &motor,
                                                 const CurveSetting &setting,
                                                 const std::vector<PointRequest> &requests,
                                                 const std::vector<CurvePoint> &starts)
    {
      std::vector<CurvePoint> points = exact(all, motor, setting, requests, starts);
      for (CurvePoint &point : points)
        point.result.input_power *= 1. + 0.04 * std::pow(setting.n_parts, -order);
      return points;
    };
    CurveSearch search(parameters, 1e-4, period, sources);
    search.find();
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
    Parameters parameters              = paper_motor();
    parameters.loading.values          = {0.}; // torque
    parameters.initial_deformation     = {};
    parameters.accuracy.contact_target = contact_target;
    parameters.accuracy.quantities     = quantities;
    CurveSearch::Sources sources       = made_up_sources(0., 0.);
    sources.points = [exact = sources.points](const Parameters &all, const CondensedMotor &motor,
                                              const CurveSetting &setting,
                                              const std::vector<PointRequest> &requests,
                                              const std::vector<CurvePoint> &starts)
    {
      std::vector<CurvePoint> points = exact(all, motor, setting, requests, starts);
      for (CurvePoint &point : points)
      {
        const double error = 0.16 * std::pow(0.5, setting.level);
        if (point.request.control == Control::torque)
          point.result.speed *= 1. + 0.1 * error;
        point.result.radial_loss = error * point.result.tangential_loss;
        point.result.input_power = // powers balance
            point.result.output_work + point.result.friction_loss();
      }
      return points;
    };
    CurveSearch search(parameters, 1e-4, period, sources);
    search.find();
    for (const QuantityTarget &held : quantities)
    {
      const CurvePoint &point = search.points().front();
      const PointError total  = point.error();
      EXPECT_LE(total[held.quantity] / quantity_named(held.quantity).value(point),
                held.target.value_or(contact_target));
    }
    return search.level();
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
  Parameters parameters              = paper_motor();
  parameters.loading.values          = {1., 3.};
  parameters.loading.control         = Control::torque;
  parameters.initial_deformation     = {};
  parameters.accuracy.contact_target = 0.05;
  const CurveSearch::Sources sources = made_up_sources(0.2, 0.1);
  CurveSearch search(parameters, 1e-3, period, sources);
  search.find();
  const Parameters frozen = search.frozen();
  EXPECT_EQ(frozen.accuracy.mode, AccuracyMode::fixed);
  EXPECT_EQ(frozen.accuracy.interface_refinement, search.level());
  CurveSearch again(frozen, 1e-3, period, sources);
  again.find();
  EXPECT_EQ(again.level(), search.level());
  for (unsigned int i = 0; i < search.points().size(); ++i)
    EXPECT_EQ(again.points()[i].result.speed, search.points()[i].result.speed) << i;
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
  EXPECT_EQ(choice(0.01).plain(3), (CurveSetting{3, 2}));
  EXPECT_EQ(choice(0.01).longest(3), (CurveSetting{3, 1}));
  EXPECT_EQ(choice(0.01).first_parts(), 2u);
  EXPECT_EQ(choice(0.01).plain(3).doubled(), (CurveSetting{3, 1}));
  EXPECT_EQ(choice(0.003).plain(1), (CurveSetting{1, 4}));
  EXPECT_EQ(choice(0.003).longest(1), (CurveSetting{1, 1}));
  EXPECT_EQ(choice(0.1).plain(1), (CurveSetting{1, 1, 2}));
  EXPECT_EQ(choice(0.1).longest(1), choice(0.1).plain(1));
  EXPECT_EQ(choice(0.1).first_parts(), 1u);
}
