// SPDX-License-Identifier: LGPL-2.1-or-later

// Error bars against true errors, where these are known: the reference stator's working mode
// (30004 +- 3 Hz, from an independent program, see reference_stator.cc) on many meshes, and a case
// with an exact solution: a hollow cylinder of length L twists without waves as u_theta = r
// cos(j pi z / L) at j c / (2 L), c the speed of shear waves, whatever its radii.

#include "support/materials.h"
#include "support/ring_sector.h"

#include <ringmotor/mesh/stator_sector.h>
#include <ringmotor/quantities/mode_search.h>

#include <gtest/gtest.h>

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
      const SectorMesh mesh = make_stator_sector(StatorGeometry(), 90, SectorForm::half,
                                                 SectorGrading::level(level), MPI_COMM_WORLD);
      search.compute(mesh, degree);
      const FoundMode *mode = search.working_mode(7);
      ASSERT_NE(mode, nullptr);
      const Estimate estimate = mode->frequency;
      EXPECT_NEAR(estimate.value, exact, estimate.error + uncertainty)
          << "degree " << degree << ", level " << level;
      // not by being too long: the true excess of the computed frequency is a fair part of the bar
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
      bool seen = false; // a twist is the part that is odd about the mirror plane: imaginary
      for (const FoundMode &mode : search.modes())
        for (unsigned int j = 1; j < 3; ++j)
          // Half a wave in each cell is odd there: its part of even degree vanishes, and with it
          // what the error bar is made from (a limit that frequency_estimate() states).
          if (j == n_axial && degree % 2 == 0)
            seen = true;
          else if (const double exact = j * wave_speed / (2. * length);
                   mode.mode.displacement.real.l2_norm() <
                       1e-6 * mode.mode.displacement.imaginary.l2_norm() &&
                   std::abs(mode.mode.frequency() / exact - 1.) < 0.11)
          {
            EXPECT_NEAR(mode.frequency.value / exact, 1., mode.frequency.error / exact + 1e-9)
                << "degree " << degree << ", " << n_axial << " cells, j = " << j;
            seen = true;
          }
      EXPECT_TRUE(seen);
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

TEST(ErrorBars, OfShapesFollowTheLastChange)
{
  // The indicator fell to a quarter, the shape's error (its square root) to a half: what is left
  // is as large as the last change, and twice that is the bar.
  const FrequencySample coarse{3, 30000., 4e-4}, fine{3, 30000., 1e-4};
  const Estimate estimate = shape_estimate(0.84, 0.83, fine, coarse, 1e-4);
  EXPECT_DOUBLE_EQ(estimate.value, 0.84);
  EXPECT_NEAR(estimate.error, 0.02, 1e-12);
  // A change that happens to be small is not believed: twice the frequency's relative error.
  EXPECT_NEAR(shape_estimate(0.84, 0.84, fine, coarse, 1e-4).error, 2e-4 * 0.84, 1e-12);
  // No progress, no trust
  EXPECT_GT(shape_estimate(0.84, 0.83, coarse, coarse, 1e-4).error, 0.02);
}
