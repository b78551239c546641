// SPDX-License-Identifier: LGPL-2.1-or-later

// Results on several ranks equal those on one: under mpirun each rank compares the mesh shared by
// all ranks with its own.

#include "support/materials.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/structure/modes.h>
#include <ringmotor/structure/refinement_indicator.h>
#include <ringmotor/structure/shared_work.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

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
        : mesh(make_sector(stator_body(StatorGeometry(), 90), form, SectorGrading::level(1),
                           communicator)),
          sector(mesh, stator_materials(), 2), solver(sector)
    {
    }
  };

  class Ranks : public testing::TestWithParam<SectorForm>
  {
  };
} // namespace

TEST(SharedWorkRanks, CarriesOutEachTaskOnce)
{
  using namespace dealii::Utilities::MPI;
  constexpr unsigned int n_tasks   = 23;
  const SharedSeconds before       = SharedSeconds::so_far();
  unsigned int n_carried_out_by_me = 0;
  std::vector<unsigned int> items;
  for (unsigned int i = 0; i < n_tasks; ++i)
    items.push_back(i);
  const auto work = [&](const unsigned int i)
  {
    ++n_carried_out_by_me;
    for (const std::clock_t begin = std::clock(); std::clock() - begin < CLOCKS_PER_SEC / 500;)
      ;
    return std::vector<unsigned int>(i + 1, i * i);
  };
  const std::vector<std::vector<unsigned int>> results = shared_work(items, work, MPI_COMM_WORLD);
  ASSERT_EQ(results.size(), n_tasks);
  for (unsigned int i = 0; i < n_tasks; ++i)
    EXPECT_EQ(results[i], std::vector<unsigned int>(i + 1, i * i));
  EXPECT_EQ(sum(n_carried_out_by_me, MPI_COMM_WORLD), n_tasks);
  EXPECT_TRUE(shared_work(std::vector<unsigned int>(), work, MPI_COMM_WORLD).empty());
  if (n_mpi_processes(MPI_COMM_WORLD) == 1)
    return;
  const SharedSeconds &after = SharedSeconds::so_far();
  double all                 = 0.;
  for (std::size_t rank = 0; rank < after.by_rank.size(); ++rank)
    all += after.by_rank[rank] - before.by_rank[rank];
  EXPECT_GE(all, 0.99 * n_tasks / 500.);
  EXPECT_GE(after.longest - before.longest, all / n_mpi_processes(MPI_COMM_WORLD));
  EXPECT_LE(after.longest - before.longest, all);
}

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
      const auto indicators = sheet_indicators(together.sector, sheets, {&modes[i].motion}).front();
      const auto indicators_alone =
          sheet_indicators(alone.sector, sheets_alone, {&modes_alone[i].motion}).front();
      ASSERT_EQ(indicators.size(), indicators_alone.size());
      for (unsigned int sheet = 0; sheet < indicators.size(); ++sheet)
        EXPECT_NEAR(indicators[sheet], indicators_alone[sheet], 1e-8 * modes[i].eigenvalue);
    }
  }
}

TEST(InertiaRanks, CountsAsManyModesAsOneRank)
{
  // Large enough that MUMPS would share the last front among the ranks (ScaLAPACK) if allowed: it
  // does not count the negative pivots there, and modes below the shift would go unnoticed.
  const auto mesh = [](MPI_Comm communicator)
  {
    return make_sector(stator_body(StatorGeometry(), 90), SectorForm::whole, {0, 2, 0.3},
                       communicator);
  };
  const SectorMesh together = mesh(MPI_COMM_WORLD), alone = mesh(MPI_COMM_SELF);
  const CyclicSector sector(together, stator_materials(), 3),
      sector_alone(alone, stator_materials(), 3);
  ModeSolver solver(sector), solver_alone(sector_alone);
  for (const double frequency : {50e3, 400e3, 2e6})
  {
    const double shift = std::pow(2. * dealii::numbers::PI * frequency, 2);
    EXPECT_EQ(solver.count_below(7, shift), solver_alone.count_below(7, shift))
        << frequency << " Hz";
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, Ranks, testing::Values(SectorForm::half, SectorForm::whole),
                         [](const auto &info)
                         { return info.param == SectorForm::half ? "Half" : "Whole"; });
