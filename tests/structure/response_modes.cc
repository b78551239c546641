// SPDX-License-Identifier: LGPL-2.1-or-later

// Ritz vectors from responses. At the frequencies for which they were made they respond to the
// loads like the stiffness shifted by these frequencies, which is factorised here; beside them the
// error is of second order; also at a resonance. They bound the modes from above.

#include "support/materials.h"
#include "support/ring_sector.h"

#include <ringmotor/structure/response_modes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  class RingUnderLoads : public ::testing::Test
  {
  protected:
    static constexpr unsigned int k = 3, n_loads = 2;
    using Forces =
        std::array<dealii::Vector<double>, 2>; // on both fields, in the axes of the nodes

    RingUnderLoads()
        : mesh(rectangular_ring(0.8, {0.1, 0.1}, 0.1, 1, 12, SectorForm::half, 2)),
          sector(mesh, all_of(steel), 2),
          resonance(std::sqrt(ModeSolver(sector).lowest(k, 1).front().eigenvalue))
    {
      std::mt19937 random;
      for (unsigned int load = 0; load < n_loads; ++load)
      {
        forces.emplace_back();
        for (dealii::Vector<double> &field : forces.back())
        {
          field.reinit(sector.n_dofs());
          for (double &force : field)
            force = std::generate_canonical<double, 53>(random) - 0.5;
        }
      }
    }

    /** @param frequencies over the first resonance */
    std::vector<Mode> ritz_vectors(const std::vector<double> &frequencies) const
    {
      std::vector<std::vector<double>> loads;
      for (const Forces &of_load : forces)
        loads.push_back(sector.loads_of(k, of_load));
      std::vector<double> at;
      for (const double frequency : frequencies)
        at.push_back(frequency * resonance);
      return ResponseModes(sector).at(k, loads, at);
    }

    double work(const Forces &of, const SectorMotion &motion) const
    {
      const Forces fields = sector.in_axes(motion);
      return of[0] * fields[0] + of[1] * fields[1];
    }

    SectorMotion motion(const Forces &load, const double square) const
    {
      CyclicFactors factors(sector);
      factors.factorise(k, square);
      std::vector<double> unknowns = sector.loads_of(k, load);
      factors.solve(unknowns);
      return sector.expand(k, unknowns);
    }

    /** Of the work of one load in the motion due to another, beyond that at rest; relative to the
     * largest. @param frequency over the first resonance */
    double error_at(const std::vector<Mode> &modes, const double frequency) const
    {
      const double square = std::pow(frequency * resonance, 2);
      double error = 0., largest = 0.;
      for (const Forces &one : forces)
      {
        const SectorMotion vibrating = motion(one, square), at_rest = motion(one, 0.);
        for (const Forces &other : forces)
        {
          const double expected = work(other, vibrating) - work(other, at_rest);
          double found          = 0.;
          for (const Mode &mode : modes)
            found += work(one, mode.motion) * work(other, mode.motion) *
                     (1. / (mode.eigenvalue - square) - 1. / mode.eigenvalue);
          error   = std::max(error, std::abs(found - expected));
          largest = std::max(largest, std::abs(expected));
        }
      }
      return error / largest;
    }

    const SectorMesh mesh;
    const CyclicSector sector;
    const double resonance; ///< rad/s, the first one
    std::vector<Forces> forces;
  };
} // namespace

TEST_F(RingUnderLoads, RespondsExactlyAtTheGivenFrequencies)
{
  const std::vector<Mode> modes = ritz_vectors({0.7, 9.3});
  EXPECT_EQ(modes.size(), 3 * n_loads);
  EXPECT_LT(error_at(modes, 0.7), 1e-9);
  EXPECT_LT(error_at(modes, 9.3), 1e-9);
  // Elsewhere it is not exact: quadratic in the distance.
  const double near = error_at(modes, 9.3 * 1.0001), far = error_at(modes, 9.3 * 1.0002);
  EXPECT_GT(near, 1e-8);
  EXPECT_LT(near, 1e-3);
  EXPECT_NEAR(far / near, 4., 0.6);
}

TEST_F(RingUnderLoads, BoundsTheModesFromAbove)
{
  const std::vector<Mode> modes = ritz_vectors({1.2}), exact = ModeSolver(sector).lowest(k, 6);
  for (unsigned int r = 0; r < modes.size(); ++r)
    EXPECT_GT(modes[r].eigenvalue, (1. - 1e-9) * exact[r].eigenvalue) << r;
  EXPECT_NEAR(modes[0].eigenvalue, exact[0].eigenvalue, 1e-4 * exact[0].eigenvalue);
}

TEST_F(RingUnderLoads, RespondsAtResonances)
{
  for (const double distance : {1e-12, 1e-6})
  {
    const std::vector<Mode> modes = ritz_vectors({1. + distance});
    EXPECT_EQ(modes.size(), 2 * n_loads) << distance;
    EXPECT_NEAR(modes[0].eigenvalue, std::pow(resonance, 2), 1e-9 * std::pow(resonance, 2))
        << distance;
    EXPECT_LT(error_at(modes, 1.01), 1e-5) << distance;
  }
}

TEST_F(RingUnderLoads, LeavesOutLoadsThatDependOnOthers)
{
  forces.push_back(forces[0]);
  forces.back()[0].add(2., forces[1][0]);
  forces.back()[1].add(2., forces[1][1]);
  const std::vector<Mode> modes = ritz_vectors({0.7});
  EXPECT_EQ(modes.size(), 2 * n_loads);
  EXPECT_LT(error_at(modes, 0.7), 1e-9);
}
