// SPDX-License-Identifier: LGPL-2.1-or-later

// Error bars against known true errors: the reference stator's working mode (30004 +- 3 Hz, from an
// independent program, see reference_stator.cc) on many meshes, stators of other shapes against
// meshes a hundred times better, and a case with an exact solution: the torsion of a hollow
// cylinder of length L without waves, u_theta = r cos(j pi z / L) at j c / (2 L), c the speed of
// shear waves, whatever its radii.

#include "support/materials.h"
#include "support/ring_sector.h"

#include <ringmotor/mesh/stator_sector.h>
#include <ringmotor/quantities/curve_search.h>
#include <ringmotor/quantities/mode_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  Modes request(const unsigned int n_waves, const unsigned int n_modes)
  {
    Modes modes;
    modes.nodal_diameters = {n_waves};
    modes.n_modes         = n_modes;
    return modes;
  }
} // namespace

TEST(ErrorBarsLong, HoldTheTrueFrequencyOfTheStator)
{
  const double exact = 30004., uncertainty = 3.;
  for (const unsigned int degree : {2u, 3u, 4u})
  {
    ModeSearch search(stator_materials(), request(7, 2));
    for (const unsigned int level : {0u, 1u, 2u, 3u, 4u})
    {
      if (degree == 4 && level > 3)
        continue;
      const SectorMesh mesh = make_stator_sector(StatorGeometry(), 90, SectorForm::half,
                                                 SectorGrading::level(level), MPI_COMM_WORLD);
      search.compute(mesh, degree);
      const FoundMode *mode = search.working_mode(7);
      ASSERT_NE(mode, nullptr);
      const Estimate estimate = mode->frequency;
      EXPECT_NEAR(estimate.value, exact, estimate.error + uncertainty)
          << "degree " << degree << ", level " << level;
      // the bar is not too long: the true excess of the computed frequency is a fair part of it
      const double excess = mode->mode.frequency() - exact;
      if (excess > 10. * uncertainty)
      {
        EXPECT_LT(2. * estimate.error, 12. * excess) << "degree " << degree << ", level " << level;
      }
      EXPECT_GT(excess, -uncertainty);
    }
  }
}

TEST(ErrorBars, HoldTheExactFrequencyOfATwistedCylinder)
{
  const double length = 0.5;
  const double wave_speed =
      std::sqrt(steel.young_modulus / (2. * (1. + steel.poisson_ratio)) / steel.density);
  for (const unsigned int degree : {2u, 3u, 4u})
    for (const unsigned int n_axial : {1u, 2u, 4u})
    {
      const SectorMesh mesh =
          rectangular_ring(0.05, {0.03}, length, n_axial, 12, SectorForm::half, 1);
      ModeSearch search(all_of(steel), request(0, 3));
      search.compute(mesh, degree);
      for (unsigned int j = 1; j < 3; ++j)
      {
        // More half waves in a cell than this are not resolved. Degree 2 does not even detect one:
        // it is odd in the cell, its quadratic part vanishes (a limit that frequency_estimate()
        // documents).
        if (j + 3 > n_axial + degree)
          continue;
        const double exact = j * wave_speed / (2. * length);
        // Torsion is odd about the mirror plane, hence imaginary.
        const auto twist =
            std::find_if(search.modes().begin(), search.modes().end(),
                         [&](const FoundMode &found)
                         {
                           const ComplexField &u = found.mode.motion.solid;
                           return u.real.l2_norm() < 1e-6 * u.imaginary.l2_norm() &&
                                  std::abs(found.mode.frequency() / exact - 1.) < 0.11;
                         });
        ASSERT_NE(twist, search.modes().end())
            << "degree " << degree << ", " << n_axial << " cells, j = " << j;
        EXPECT_NEAR(twist->frequency.value / exact, 1., twist->frequency.error / exact + 1e-9)
            << "degree " << degree << ", " << n_axial << " cells, j = " << j;
      }
    }
}

TEST(ErrorBarsLong, HoldWhatAFarBetterMeshFinds)
{
  // A stator with wide slots and high teeth, and a small one of few teeth without a ceramic ring.
  StatorGeometry wide, small;
  wide.base_inner_radius = wide.tip_inner_radius = 24e-3;
  wide.base_outer_radius = wide.tip_outer_radius = 30e-3;
  wide.base_thickness = wide.tooth_height = 3e-3;
  wide.slot_width                         = 0.8e-3;
  small.base_inner_radius = small.tip_inner_radius = 10e-3;
  small.base_outer_radius                          = 14e-3;
  small.tip_outer_radius                           = 13e-3;
  small.base_thickness                             = 2e-3;
  small.tooth_height                               = 1e-3;
  small.slot_width                                 = 0.5e-3;
  small.piezoceramic_thickness                     = 0.;
  struct Case
  {
    StatorGeometry stator;
    unsigned int n_teeth, n_waves;
  };
  for (const Case &sample : {Case{wide, 90, 9}, Case{small, 30, 3}})
  {
    const auto search_on =
        [&, modes = request(sample.n_waves, 2)](const unsigned int level, const unsigned int degree)
    {
      const SectorMesh mesh = make_stator_sector(sample.stator, sample.n_teeth, SectorForm::half,
                                                 SectorGrading::level(level), MPI_COMM_WORLD);
      ModeSearch search(stator_materials(), modes);
      search.compute(mesh, degree);
      std::vector<Estimate> found;
      for (const FoundMode &mode : search.modes())
        found.push_back({mode.frequency.value, mode.frequency.error});
      return found;
    };
    const std::vector<Estimate> best = search_on(3, 4);
    for (const unsigned int degree : {2u, 3u, 4u, 5u})
      for (const unsigned int level : {0u, 1u})
      {
        if (degree == 5 && level > 0)
          continue;
        const std::vector<Estimate> found = search_on(level, degree);
        for (unsigned int i = 0; i < 2; ++i)
        {
          EXPECT_NEAR(found[i].value, best[i].value, found[i].error + best[i].error)
              << sample.n_teeth << " teeth, degree " << degree << ", level " << level;
          EXPECT_LT(best[i].error, 0.5 * found[i].error);
        }
      }
  }
}

TEST(ErrorBarsLong, ShrinkAsTheMeshIsRefined)
{
  ModeSearch search(stator_materials(), request(7, 2));
  SectorMesh mesh = make_stator_sector(StatorGeometry(), 90, SectorForm::half,
                                       SectorGrading::level(0), MPI_COMM_WORLD);
  search.compute(mesh, 3);
  const double first = search.worst_relative_error();
  double earlier     = first;
  for (unsigned int pass = 0; pass < 4; ++pass)
  {
    search.refine(mesh);
    search.compute(mesh, 3);
    EXPECT_LT(search.worst_relative_error(), 1.05 * earlier) << "pass " << pass;
    earlier               = search.worst_relative_error();
    const FoundMode *mode = search.working_mode(7);
    ASSERT_NE(mode, nullptr);
    EXPECT_EQ(mode->samples.size(), pass + 2);
    EXPECT_NEAR(mode->frequency.value, 30004., mode->frequency.error + 3.);
  }
  EXPECT_LT(earlier, 0.15 * first);
}

TEST(ErrorBars, OfHopelessMeshesDoNotReachBelowZero)
{
  const Estimate estimate = frequency_estimate({2, 1000., 50.});
  EXPECT_DOUBLE_EQ(estimate.value, 500.);
  EXPECT_DOUBLE_EQ(estimate.error, 500.);
}

TEST(ErrorBars, OfShapesFollowTheLastChange)
{
  // The indicator fell to a quarter, the shape's error (its square root) to a half: the remaining
  // error equals the last change, and the bar is twice that.
  const FrequencySample coarse{3, 30000., 4e-4}, fine{3, 30000., 1e-4};
  const Estimate estimate = shape_estimate(0.84, 0.83, fine, coarse, 1e-4);
  EXPECT_DOUBLE_EQ(estimate.value, 0.84);
  EXPECT_NEAR(estimate.error, 0.02, 1e-12);
  // A change that happens to be small is not trusted: twice the frequency's relative error.
  EXPECT_NEAR(shape_estimate(0.84, 0.84, fine, coarse, 1e-4).error, 2e-4 * 0.84, 1e-12);
  // Without progress the bar is longer
  EXPECT_GT(shape_estimate(0.84, 0.83, coarse, coarse, 1e-4).error, 0.02);
}

namespace
{
  constexpr double window_error = 0.01; // rad/s, of synthetic points that report it
  constexpr double period       = 1e-5 * dealii::numbers::PI; // s, of the synthetic wave

  /** Synthetic sources of points: speeds w0 - T with a mesh error a / 4^level, a time step error
   * b/n for n parts, and an error in proportion to the wave; powers balance with four parts. */
  CurveSearch::Sources made_up_sources(const double a, const double b)
  {
    CurveSearch::Sources sources;
    sources.motor = [](unsigned int, unsigned int)
    {
      CondensedMotor motor;
      motor.n_teeth           = 90;
      motor.n_waves           = 7;
      motor.angular_frequency = 2. * dealii::numbers::PI / period;
      motor.nodes  = {{1., 0., 1., {}}, {2., 0., 1., {}}, {1., 0.1, 1., {}}, {2., 0.1, 1., {}}};
      motor.faces  = {{0, 1, 2, 3}};
      motor.degree = 1;
      return motor;
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
        point.result.input_power     = 1.;
        point.result.output_work     = 0.5;
        point.result.tangential_loss = setting.n_parts < 4 ? 0.49 : 0.5;
        point.fields.time_step       = 1e-7;
        point.tells_window           = setting.tells_window;
        point.window.speed           = setting.tells_window ? window_error : 0.;
        points.push_back(point);
      }
      return points;
    };
    return sources;
  }

  CurvePoint point_at(const double torque, const std::vector<double> &asked_for, const double a,
                      const double b)
  {
    Parameters parameters;
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

TEST(ErrorBars, OfOperatingPointsHoldTheirErrorsCauseByCause)
{
  constexpr double a = 0.2, b = 0.1, torque = 3., exact = 8. - torque;
  const CurvePoint point  = point_at(torque, {torque}, a, b);
  const PointErrors &bars = point.errors;
  // Level 1, and four parts, with which powers balance
  EXPECT_NEAR(point.result.speed, exact + a * 0.25 * (1. + torque) + b / 4., 1e-12);
  EXPECT_GE(bars.mesh.speed, a * 0.25 * (1. + torque));
  EXPECT_LE(bars.mesh.speed, 8. * a * 0.25 * (1. + torque));
  EXPECT_NEAR(bars.time.speed, b / 4., 1e-12); // exact for an error of first order
  EXPECT_NEAR(bars.wave.speed, 1e-3 * exact, 1e-12);
  EXPECT_EQ(bars.total().torque, 0.); // prescribed
}

TEST(ErrorBars, OfAnOperatingPointDoNotDependOnTheOthers)
{
  const CurvePoint alone = point_at(3., {3.}, 0.2, 0.1),
                   among = point_at(3., {0., 1., 3., 7.9}, 0.2, 0.1);
  EXPECT_EQ(alone.result.speed, among.result.speed);
  for (unsigned int i = 0; i < alone.errors.causes().size(); ++i)
    EXPECT_EQ(alone.errors.causes()[i].second.speed, among.errors.causes()[i].second.speed) << i;
}

TEST(ErrorBars, OfMeshesFollowTheLastChange)
{
  // Errors of the meshes 0 to 3.
  const auto mesh_bar =
      [](const std::array<double, 4> &errors, const double target, const unsigned int level)
  {
    Parameters parameters;
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
    return search.points().front().errors.mesh.speed;
  };
  const std::array<double, 4> regular{{0.36, 0.12, 0.04, 0.01}};
  EXPECT_NEAR(mesh_bar(regular, 0.1, 1), 2. * 0.24, 1e-12);
  EXPECT_NEAR(mesh_bar(regular, 0.02, 2), 1.25 * 0.08, 1e-12);
  EXPECT_NEAR(mesh_bar(regular, 0.006, 3), 1.25 * 0.03, 1e-12);
  // A last change that happens to be small is not trusted: a third of the one before.
  EXPECT_NEAR(mesh_bar({{0.36, 0.12, 0.12, 0.}}, 0.02, 2), 1.25 * 0.08, 1e-12);
  // Values that swing about their limit
  EXPECT_NEAR(mesh_bar({{0.2, -0.1, 0.03, -0.01}}, 0.025, 2), 1.25 * 0.13, 1e-12);
}

TEST(ErrorBars, HaveTheAveragingWindowOfTheMeshThatIsShown)
{
  Parameters parameters;
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
  const auto every_bar_has_it = [&]
  {
    for (const CurvePoint &point : search.points())
      EXPECT_EQ(point.errors.window.speed, window_error);
  };
  every_bar_has_it();
  EXPECT_EQ(levels.count(0), 3u); // including stall, by which the curve is judged
  EXPECT_EQ(levels.count(1), 0u);
  // A mesh previously used for comparison only
  search.climb([&](const CurveSearch::Rung &) { every_bar_has_it(); });
  EXPECT_EQ(levels.count(1), 2u);
}

TEST(ErrorBars, LeadToFinerModesWhereTheseMatterMost)
{
  // Errors of c, c/3 and c/9 at three levels of modes.
  Parameters parameters;
  parameters.loading.values          = {3.};
  parameters.loading.control         = Control::torque;
  parameters.initial_deformation     = {};
  parameters.accuracy.contact_target = 0.1;
  for (const auto &[c, level] : {std::pair(1., 1u), std::pair(3., 2u)})
  {
    CurveSearch::Sources sources = made_up_sources(0.02, 0.);
    sources.motor = [of_all = sources.motor](const unsigned int mesh, const unsigned int modes)
    {
      CondensedMotor motor = of_all(mesh, modes);
      motor.modes_level    = modes;
      motor.modes          = {{{1e5, {}}}};
      return motor;
    };
    sources.points = [error = c, of_all = sources.points](
                         const Parameters &all, const CondensedMotor &motor,
                         const CurveSetting &setting, const std::vector<PointRequest> &requests,
                         const std::vector<CurvePoint> &starts)
    {
      std::vector<CurvePoint> points  = of_all(all, motor, setting, requests, starts);
      const unsigned int modes_in_use = motor.modes_level - (setting.has_coarse_modes ? 1 : 0);
      for (CurvePoint &point : points)
        if (point.request.control == Control::torque)
          point.result.speed += error / std::pow(3., modes_in_use);
      return points;
    };
    CurveSearch search(parameters, 1e-3, period, sources);
    search.find();
    EXPECT_EQ(search.motor().modes_level, level);
    const PointErrors &bars = search.points().front().errors;
    EXPECT_NEAR(bars.modes.speed, 0.6 * c * (std::pow(3., 1. - level) - std::pow(3., -1. * level)),
                1e-12);
    EXPECT_GT(bars.modes.speed, c * std::pow(3., -1. * level));
  }
}
