// SPDX-License-Identifier: LGPL-2.1-or-later

// The same numbers on several ranks as on one: under mpirun each rank compares the mesh that all
// ranks share with one of its own.

#include "support/materials.h"

#include <ringmotor/mesh/stator_sector.h>
#include <ringmotor/structure/modes.h>
#include <ringmotor/structure/refinement_indicator.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  struct Model
  {
    SectorMesh mesh;
    CyclicSector sector;
    ModeSolver solver;

    Model(const SectorForm form, MPI_Comm communicator)
        : mesh(make_stator_sector(StatorGeometry(), 90, form, SectorGrading::level(1),
                                  communicator)),
          sector(mesh, stator_materials(), 2), solver(sector)
    {
    }
  };

  class Ranks : public testing::TestWithParam<SectorForm>
  {
  };
} // namespace

TEST_P(Ranks, GiveTheSameModes)
{
  ASSERT_GT(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD), 1u);
  Model together(GetParam(), MPI_COMM_WORLD), alone(GetParam(), MPI_COMM_SELF);
  ASSERT_LT(together.mesh.triangulation->n_locally_owned_active_cells(),
            alone.mesh.triangulation->n_locally_owned_active_cells());
  ASSERT_EQ(together.sector.n_unknowns(), alone.sector.n_unknowns());
  const Sheets sheets(together.mesh), sheets_alone(alone.mesh);

  for (const unsigned int k : {0u, 7u})
  {
    const double shift = alone.solver.shift_above(k, 3, 0.);
    EXPECT_NEAR(together.solver.shift_above(k, 3, 0.) / shift, 1., 1e-9);
    const std::vector<Mode> modes       = together.solver.below(k, shift);
    const std::vector<Mode> modes_alone = alone.solver.below(k, shift);
    ASSERT_EQ(modes.size(), modes_alone.size());
    for (unsigned int i = 0; i < modes.size(); ++i)
    {
      ASSERT_EQ(modes[i].rigid, modes_alone[i].rigid);
      if (modes[i].rigid)
        continue;
      EXPECT_NEAR(modes[i].frequency() / modes_alone[i].frequency(), 1., 1e-10);
      const auto indicators =
          sheet_indicators(together.sector, sheets, {&modes[i].displacement}).front();
      const auto indicators_alone =
          sheet_indicators(alone.sector, sheets_alone, {&modes_alone[i].displacement}).front();
      ASSERT_EQ(indicators.size(), indicators_alone.size());
      for (unsigned int sheet = 0; sheet < indicators.size(); ++sheet)
        EXPECT_NEAR(indicators[sheet], indicators_alone[sheet], 1e-8);
    }
  }
}

TEST(SparseLDLTRanks, CountNegativePivotsOfADenseMatrix)
{
  // Q D Q with the reflection Q = I - 2 v v^T has the signs of the diagonal matrix D. All of a
  // dense matrix is eliminated in one front, the one that the ranks share.
  const unsigned int size = 700, n_negative = 250;
  std::vector<double> mirror(size), diagonal(size);
  for (unsigned int i = 0; i < size; ++i)
  {
    mirror[i]   = 1. + std::sin(3. * i);
    diagonal[i] = (i < n_negative ? -1. : 1.) * (1. + i % 7);
  }
  const double norm =
      std::sqrt(std::inner_product(mirror.begin(), mirror.end(), mirror.begin(), 0.));
  for (double &entry : mirror)
    entry /= norm;
  double middle = 0.;
  for (unsigned int i = 0; i < size; ++i)
    middle += mirror[i] * diagonal[i] * mirror[i];
  const auto entry = [&](const unsigned int i, const unsigned int j)
  {
    return (i == j ? diagonal[i] : 0.) +
           mirror[i] * mirror[j] * (4. * middle - 2. * (diagonal[i] + diagonal[j]));
  };

  const unsigned int rank    = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  SymmetricTriplets triplets;
  for (unsigned int i = rank; i < size; i += n_ranks)
    for (unsigned int j = 0; j <= i; ++j)
      triplets.add(i, j, entry(i, j));
  SparseLDLT factors(size, MPI_COMM_WORLD);
  factors.factorise(triplets);
  EXPECT_EQ(factors.n_negative(), n_negative);

  std::vector<double> x(size, 0.);
  for (unsigned int i = 0; i < size; ++i)
    for (unsigned int j = 0; j < size; ++j)
      x[i] += entry(i, j) * (j + 1.);
  factors.solve(x);
  for (unsigned int i = 0; i < size; ++i)
    EXPECT_NEAR(x[i], i + 1., 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Forms, Ranks, testing::Values(SectorForm::half, SectorForm::whole),
                         [](const auto &info)
                         { return info.param == SectorForm::half ? "Half" : "Whole"; });
