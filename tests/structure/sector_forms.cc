// SPDX-License-Identifier: LGPL-2.1-or-later

// The two forms of the cyclic sector against each other and against their defining properties. The
// half sector with its mirror plane and the whole sector with Bloch's condition have different
// matrices for the same problem, so their eigenvalues agree up to rounding. k and N - k are the
// same wave travelling in opposite directions. The rigid motions of a free ring are known: axial
// shift and spin in k = 0, in-plane shift and tilt in k = 1 (each a pair of standing motions), none
// beyond.

#include "support/materials.h"
#include "support/record.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/structure/modes.h>

#include <deal.II/dofs/dof_tools.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  /** The reference stator on a coarse mesh: all statements here hold on any mesh. */
  struct CoarseStator
  {
    SectorMesh mesh;
    CyclicSector sector;
    ModeSolver solver;

    explicit CoarseStator(const SectorForm form, const unsigned int level = 0)
        : mesh(make_sector(stator_body(StatorGeometry(), 90), form, SectorGrading::level(level),
                           MPI_COMM_WORLD)),
          sector(mesh, stator_materials(), 2), solver(sector)
    {
    }
  };

  std::vector<double> elastic_frequencies(const std::vector<Mode> &modes)
  {
    std::vector<double> frequencies;
    for (const Mode &mode : modes)
      if (!mode.rigid)
        frequencies.push_back(mode.frequency());
    return frequencies;
  }

  void expect_equal(const std::vector<double> &found, const std::vector<double> &expected,
                    const double relative_tolerance)
  {
    ASSERT_EQ(found.size(), expected.size());
    double largest = 0.;
    for (unsigned int i = 0; i < found.size(); ++i)
    {
      largest = std::max(largest, std::abs(found[i] / expected[i] - 1.));
      EXPECT_NEAR(found[i], expected[i], relative_tolerance * expected[i]) << "mode " << i;
    }
    record("largest relative difference of frequencies", largest);
  }

  class SectorForms : public testing::TestWithParam<unsigned int>
  {
  };
} // namespace

TEST_P(SectorForms, HalfEqualsWhole)
{
  CoarseStator half(SectorForm::half), whole(SectorForm::whole);
  const unsigned int k = GetParam();
  // Not far above the modes compared: rounding errors are of the order of the shift.
  const double shift = half.solver.shift_above(k, 2, 0.);
  const auto of_half = elastic_frequencies(half.solver.below(k, shift));
  ASSERT_GE(of_half.size(), 2u);
  expect_equal(of_half, elastic_frequencies(whole.solver.below(k, shift)), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(NodalDiameters, SectorForms, testing::Values(0, 1, 2, 7, 45));

TEST(Sector, WavesRunEitherWay)
{
  CoarseStator whole(SectorForm::whole);
  for (const unsigned int k : {2u, 7u, 44u})
    expect_equal(elastic_frequencies(whole.solver.lowest(90 - k, 4)),
                 elastic_frequencies(whole.solver.lowest(k, 4)), 1e-10);
}

TEST(Sector, KnowsRigidMotions)
{
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    CoarseStator stator(form);
    for (const unsigned int k : {0u, 1u, 2u, 3u})
    {
      const std::vector<Mode> modes = stator.solver.lowest(k, 3);
      const auto n_rigid =
          std::count_if(modes.begin(), modes.end(), [](const Mode &mode) { return mode.rigid; });
      EXPECT_EQ(n_rigid, k < 2 ? 2 : 0) << "k = " << k;
      for (const Mode &mode : modes)
        if (mode.rigid)
          EXPECT_LT(mode.frequency(), 0.1) << "k = " << k;
        else
          EXPECT_GT(mode.frequency(), 1000.) << "k = " << k;
    }
  }
}

TEST(Sector, FindsAllModesBelowAShift)
{
  // lowest() uses another shift and requests the other end of the spectrum from ARPACK.
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    CoarseStator stator(form);
    for (const unsigned int k : {0u, 1u, 7u})
    {
      const std::vector<Mode> lowest = stator.solver.lowest(k, 10);
      const double shift             = 0.5 * (lowest[7].eigenvalue + lowest[8].eigenvalue);
      EXPECT_EQ(stator.solver.count_below(k, shift), 8u);
      const std::vector<Mode> below = stator.solver.below(k, shift);
      ASSERT_EQ(below.size(), 8u);
      for (unsigned int i = 0; i < 8; ++i)
      {
        EXPECT_EQ(below[i].rigid, lowest[i].rigid);
        if (!below[i].rigid)
        {
          EXPECT_NEAR(below[i].eigenvalue / lowest[i].eigenvalue, 1., 1e-9);
        }
      }
      EXPECT_EQ(stator.solver.below(k, -1e6).size(), 0u);
    }
  }
}

TEST(Sector, LeavesAGapAboveTheWantedModes)
{
  CoarseStator coarse(SectorForm::half), fine(SectorForm::half, 1);
  for (const unsigned int k : {0u, 1u, 7u})
  {
    const double shift             = coarse.solver.shift_above(k, 2, 0.);
    const std::vector<Mode> wanted = nearest_elastic(coarse.solver.lowest(k, 4), 2, 0.);
    EXPECT_GT(shift, 1.02 * wanted.back().eigenvalue);
    EXPECT_GE(nearest_elastic(fine.solver.below(k, shift), 10, 0.).size(), 2u);
  }
  // With a target in mid-spectrum, the two modes on either side of it lie below the shift.
  const std::vector<double> all = elastic_frequencies(coarse.solver.lowest(7, 6));
  const double target           = 0.5 * (all[2] + all[3]);
  const double shift            = coarse.solver.shift_above(7, 2, target);
  const auto nearest =
      elastic_frequencies(nearest_elastic(coarse.solver.below(7, shift), 2, target));
  std::vector<double> expected = all;
  std::sort(expected.begin(), expected.end(),
            [&](const double a, const double b)
            { return std::abs(a - target) < std::abs(b - target); });
  expected.resize(2);
  std::sort(expected.begin(), expected.end());
  expect_equal(nearest, expected, 1e-9);
}

namespace
{
  /** Checks that both fields of a mode together have mass 1 and Rayleigh's quotient. */
  void expect_normalised(CoarseStator &stator, const Mode &mode)
  {
    double mass_norm = 0., stiffness_norm = 0.;
    stator.sector.for_each_owned_cell(
        [&](const auto &cell, SolidElement &element)
        {
          const unsigned int size = stator.sector.dofs().get_fe().n_dofs_per_cell();
          dealii::FullMatrix<double> stiffness(size, size), mass(size, size);
          element.matrices(stiffness, mass);
          dealii::Vector<double> values(size);
          for (const auto *field : {&mode.motion.solid.real, &mode.motion.solid.imaginary})
          {
            cell->get_dof_values(*field, values);
            mass_norm += mass.matrix_norm_square(values);
            stiffness_norm += stiffness.matrix_norm_square(values);
          }
        });
    mass_norm      = dealii::Utilities::MPI::sum(mass_norm, MPI_COMM_WORLD);
    stiffness_norm = dealii::Utilities::MPI::sum(stiffness_norm, MPI_COMM_WORLD);
    EXPECT_NEAR(mass_norm, 1., 1e-12);
    EXPECT_NEAR(stiffness_norm / mode.eigenvalue, 1., 1e-9);
  }

  /** Displacements on the two cuts of a sector by position (r, z), and the largest displacement. */
  struct OnCuts
  {
    std::map<std::pair<long, long>, std::array<std::complex<double>, 3>> low, high;
    double largest = 0.;
  };

  OnCuts on_cuts(CoarseStator &stator, const Mode &mode, const double alpha)
  {
    const dealii::DoFHandler<3> &dofs = stator.sector.dofs();
    std::vector<dealii::Point<3>> positions(dofs.n_dofs());
    dealii::DoFTools::map_dofs_to_support_points(stator.sector.geometry(), dofs, positions);
    OnCuts cuts;
    for (const auto &cell : dofs.active_cell_iterators())
    {
      std::vector<dealii::types::global_dof_index> cell_dofs(dofs.get_fe().n_dofs_per_cell());
      cell->get_dof_indices(cell_dofs);
      for (unsigned int i = 0; i < cell_dofs.size(); ++i)
      {
        const auto dof           = cell_dofs[i];
        const dealii::Point<3> x = positions[dof];
        const double theta       = std::atan2(x[1], x[0]);
        const std::complex<double> value(mode.motion.solid.real[dof],
                                         mode.motion.solid.imaginary[dof]);
        cuts.largest         = std::max(cuts.largest, std::abs(value));
        const unsigned int d = dofs.get_fe().system_to_component_index(i).first;
        const auto place =
            std::make_pair(std::lround(1e9 * std::hypot(x[0], x[1])), std::lround(1e9 * x[2]));
        if (std::abs(theta - 0.5 * alpha) < 1e-9)
          cuts.high[place][d] = value;
        else if (std::abs(theta + 0.5 * alpha) < 1e-9)
          cuts.low[place][d] = value;
      }
    }
    return cuts;
  }
} // namespace

TEST(Sector, ExpandsModesToFields)
{
  // Properties of a mode, checked on its Cartesian field: normalised mass, Rayleigh's quotient, and
  // on the cuts U(high) = exp(-i k alpha) R(alpha) U(low) or, of a half sector, that it is its own
  // mirror image up to the wave's phase: V = S conj(V) exp(-i k alpha) across the cut.
  const double alpha              = 2. * dealii::numbers::PI / 90;
  const std::complex<double> wave = std::polar(1., -7. * alpha);
  const double c = std::cos(alpha), s = std::sin(alpha);
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    CoarseStator stator(form);
    for (const Mode &mode : nearest_elastic(stator.solver.lowest(7, 3), 3, 0.))
    {
      expect_normalised(stator, mode);
      OnCuts cuts = on_cuts(stator, mode, alpha);
      if (form == SectorForm::half)
        for (const auto &[where, u] : cuts.high) // the mirror image U(-theta) = S conj(U(theta))
          cuts.low[where] = {{std::conj(u[0]), -std::conj(u[1]), std::conj(u[2])}};
      ASSERT_GT(cuts.high.size(), 10u);
      ASSERT_EQ(cuts.high.size(), cuts.low.size());
      for (const auto &[where, u] : cuts.high)
      {
        const auto &v = cuts.low.at(where);
        EXPECT_LT(std::abs(u[0] - wave * (c * v[0] - s * v[1])), 1e-10 * cuts.largest);
        EXPECT_LT(std::abs(u[1] - wave * (s * v[0] + c * v[1])), 1e-10 * cuts.largest);
        EXPECT_LT(std::abs(u[2] - wave * v[2]), 1e-10 * cuts.largest);
      }
    }
  }
}
