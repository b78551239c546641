// SPDX-License-Identifier: LGPL-2.1-or-later

// Error bars against known true errors: the reference stator's working mode (30004 +- 3 Hz, from an
// independent program, see reference_stator.cc) on many meshes, stators of other shapes against
// meshes a hundred times better, and a case with an exact solution: the torsion of a hollow
// cylinder of length L without waves, u_theta = r cos(j pi z / L) at j c / (2 L), c the speed of
// shear waves, whatever its radii.

#include "support/materials.h"
#include "support/ring_sector.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/wave/mode_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

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
      const SectorMesh mesh = make_sector(stator_body(StatorGeometry(), 90), SectorForm::half,
                                          SectorGrading::level(level), MPI_COMM_WORLD);
      search.compute(mesh, degree);
      const FoundMode *mode = search.working_mode(7);
      ASSERT_NE(mode, nullptr);
      const Estimate estimate = mode->frequency;
      EXPECT_NEAR(estimate.value, exact, estimate.error() + uncertainty)
          << "degree " << degree << ", level " << level;
      // the bar is not too long: the true excess of the computed frequency is a fair part of it
      const double excess = mode->mode.frequency() - exact;
      if (excess > 10. * uncertainty)
      {
        EXPECT_LT(2. * estimate.error(), 12. * excess)
            << "degree " << degree << ", level " << level;
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
        EXPECT_NEAR(twist->frequency.value / exact, 1., twist->frequency.error() / exact + 1e-9)
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
      const SectorMesh mesh =
          make_sector(stator_body(sample.stator, sample.n_teeth), SectorForm::half,
                      SectorGrading::level(level), MPI_COMM_WORLD);
      ModeSearch search(stator_materials(), modes);
      search.compute(mesh, degree);
      std::vector<Estimate> found;
      for (const FoundMode &mode : search.modes())
        found.push_back(mode.frequency);
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
          EXPECT_NEAR(found[i].value, best[i].value, found[i].error() + best[i].error())
              << sample.n_teeth << " teeth, degree " << degree << ", level " << level;
          EXPECT_LT(best[i].error(), 0.5 * found[i].error());
        }
      }
  }
}

TEST(ErrorBarsLong, ShrinkAsTheMeshIsRefined)
{
  ModeSearch search(stator_materials(), request(7, 2));
  SectorMesh mesh = make_sector(stator_body(StatorGeometry(), 90), SectorForm::half,
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
    EXPECT_NEAR(mode->frequency.value, 30004., mode->frequency.error() + 3.);
  }
  EXPECT_LT(earlier, 0.15 * first);
}

TEST(ErrorBars, OfHopelessMeshesDoNotReachBelowZero)
{
  const Estimate estimate = frequency_estimate({2, 1000., 50.});
  EXPECT_DOUBLE_EQ(estimate.value, 500.);
  EXPECT_DOUBLE_EQ(estimate.error(), 500.);
}

TEST(ErrorBars, OfShapesFollowTheLastChange)
{
  // The indicator fell to a quarter, the shape's error (its square root) to a half: the remaining
  // error equals the last change, and the bar is twice that.
  const FrequencySample coarse{3, 30000., 4e-4}, fine{3, 30000., 1e-4};
  const Estimate estimate = shape_estimate(0.84, 0.83, fine, coarse, 1e-4);
  EXPECT_DOUBLE_EQ(estimate.value, 0.84);
  EXPECT_NEAR(estimate.error(), 0.02, 1e-12);
  // A change that happens to be small is not trusted: twice the frequency's relative error.
  EXPECT_NEAR(shape_estimate(0.84, 0.84, fine, coarse, 1e-4).error(), 2e-4 * 0.84, 1e-12);
  // Without progress the bar is longer
  EXPECT_GT(shape_estimate(0.84, 0.83, coarse, coarse, 1e-4).error(), 0.02);
}
