// SPDX-License-Identifier: LGPL-2.1-or-later

// Modes of a whole ring, in which nothing is known of its symmetry: against those of its sector,
// which tests/structure/full_ring.cc compares with a ring made otherwise; and, with one tooth
// missing, against the dense eigenproblem (LAPACK).

#include "support/materials.h"
#include "support/plain_problem.h"
#include "support/record.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/whole_ring.h>
#include <ringmotor/structure/ring_solver.h>
#include <ringmotor/wave/ring_content.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  constexpr unsigned int n_teeth = 8;

  StatorGeometry few_teeth()
  {
    StatorGeometry stator;
    stator.slot_width = 4e-3;
    return stator;
  }

  SectorMesh sector(const SectorForm form)
  {
    return make_sector(stator_body(few_teeth(), n_teeth), form, SectorGrading::level(0),
                       MPI_COMM_SELF);
  }

  /** The modes of one nodal diameter after the other, as often as the ring has them. */
  std::vector<Mode> modes_of_sector(const CyclicSector &of_one, const double limit)
  {
    ModeSolver solver(of_one);
    std::vector<Mode> all;
    for (unsigned int k = 0; k <= n_teeth / 2; ++k)
      for (const Mode &mode : solver.below(k, squared_rate(limit)))
        if (!mode.rigid)
          all.insert(all.end(), k != 0 && 2 * k != n_teeth ? 2 : 1, mode);
    std::sort(all.begin(), all.end(),
              [](const Mode &a, const Mode &b) { return a.eigenvalue < b.eigenvalue; });
    return all;
  }

  class WholeRingForms : public testing::TestWithParam<SectorForm>
  {
  };
} // namespace

TEST_P(WholeRingForms, HasThePairsOfItsSector)
{
  const SectorMesh part = sector(GetParam()), mesh = whole_ring(part, MPI_COMM_SELF);
  ASSERT_EQ(mesh.triangulation->n_active_cells(), part.triangulation->n_active_cells() * n_teeth *
                                                      (GetParam() == SectorForm::half ? 2 : 1));
  const CyclicSector one(part, stator_materials(), 2), ring(mesh, stator_materials(), 2);
  RingSolver solver(ring);
  const double target           = 30e3;
  const ShiftWindow window      = solver.window_around(6, target);
  const std::vector<Mode> found = solver.between(window);
  std::vector<Mode> expected    = modes_of_sector(one, frequency_of(window.high));
  expected.erase(expected.begin(),
                 std::find_if(expected.begin(), expected.end(),
                              [&](const Mode &mode) { return mode.eigenvalue > window.low; }));
  ASSERT_GE(found.size(), 6u);
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_LT(window.low, squared_rate(target));
  EXPECT_GT(window.high, squared_rate(target));
  const std::vector<RingContent> contents = ring_contents(ring, found, n_teeth / 2);
  double largest = 0., between = 0.;
  unsigned int n_pairs = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    largest = std::max(largest, std::abs(found[i].frequency() / expected[i].frequency() - 1.));
    const unsigned int k = expected[i].nodal_diameter;
    if (k == 0 || 2 * k == n_teeth || i + 1 == found.size() ||
        expected[i + 1].eigenvalue != expected[i].eigenvalue)
      continue;
    ++n_pairs;
    between = std::max(between, std::abs(found[i + 1].frequency() / found[i].frequency() - 1.));
    const RingContent &cosine = contents[i], &sine = contents[i + 1];
    if (cosine.share < 0.5) // deforms the cross-section
      continue;
    EXPECT_EQ(cosine.n_waves, k);
    EXPECT_EQ(sine.n_waves, k);
    const double quarter = 0.5 * dealii::numbers::PI / k;
    EXPECT_NEAR(std::abs(cosine.antinode - sine.antinode), quarter, 1e-3 * quarter);
    const ModeContent of_sector = mode_content(one, expected[i]);
    EXPECT_NEAR(cosine.content.axial, of_sector.axial, 1e-6);
    EXPECT_NEAR(cosine.content.in_plane, of_sector.in_plane, 1e-6);
    EXPECT_EQ(cosine.content.nodal_circles, of_sector.nodal_circles);
  }
  EXPECT_GE(n_pairs, 2u);
  EXPECT_LT(largest, 1e-6);
  EXPECT_LT(between, 1e-9);
  record("largest relative difference of frequencies from the sector", largest);
  record("largest relative difference within a pair", between);
}

INSTANTIATE_TEST_SUITE_P(, WholeRingForms, testing::Values(SectorForm::half, SectorForm::whole),
                         [](const auto &info)
                         { return info.param == SectorForm::half ? "Half" : "Whole"; });

namespace
{
  /** Few cells, as dense matrices take their time. */
  SectorMesh coarse_sector()
  {
    SectorGrading grading;
    grading.even = EvenCells{1, 1, 1, 1};
    return make_sector(stator_body(few_teeth(), n_teeth), SectorForm::half, grading, MPI_COMM_SELF);
  }

  /** The ring without the tooth at the x axis. */
  SectorMesh without_a_tooth()
  {
    const SectorMesh all           = whole_ring(coarse_sector(), MPI_COMM_SELF);
    std::vector<Point<3>> vertices = all.triangulation->get_vertices();
    std::vector<dealii::CellData<3>> cells;
    for (const auto &cell : all.triangulation->active_cell_iterators())
      if (cell->material_id() != ids::tooth ||
          std::abs(cylindrical(cell->center())[1]) > dealii::numbers::PI / n_teeth)
      {
        cells.emplace_back();
        cells.back().material_id = cell->material_id();
        for (const unsigned int i : cell->vertex_indices())
          cells.back().vertices[i] = cell->vertex_index(i);
      }
    dealii::SubCellData none;
    dealii::GridTools::delete_unused_vertices(vertices, cells, none);
    SectorMesh mesh{empty_triangulation<3>(MPI_COMM_SELF), SectorForm::ring, 1};
    mesh.has_cuts = false;
    mesh.triangulation->create_triangulation(vertices, cells, none);
    mesh.triangulation->set_all_manifold_ids(0);
    mesh.triangulation->set_manifold(0, dealii::CylindricalManifold<3>(2));
    return mesh;
  }
} // namespace

TEST(WholeRing, WithAToothMissingHasTheDenseSpectrum)
{
  const SectorMesh mesh = without_a_tooth();
  const CyclicSector ring(mesh, stator_materials(), 1);
  const PlainProblem plain(*mesh.triangulation, stator_materials(), 1,
                           [](unsigned int, const Point<3> &) { return false; });
  ASSERT_EQ(plain.n_unknowns(), ring.n_unknowns());
  RingSolver solver(ring);
  std::vector<double> dense = plain.dense();
  dense.erase(dense.begin(), dense.begin() + 3); // shifts; linear curved cells resist rotations
  for (const double target : {0., frequency_of(dense[20])})
  {
    const ShiftWindow window      = solver.window_around(8, target);
    const std::vector<Mode> found = solver.between(window);
    std::vector<double> expected;
    for (const double value : dense)
      if (value > window.low && value < window.high)
        expected.push_back(value);
    ASSERT_GE(found.size(), 8u);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i].eigenvalue / expected[i], 1., 1e-9);
  }
  // The lowest pair, in which the ring with all teeth has two equal frequencies
  const double split = dense[1] / dense[0] - 1.;
  EXPECT_GT(split, 1e-3);
  record("split of the lowest pair (squared frequencies)", split);
}

TEST(WholeRingRanks, HaveTheModesOfOneRank)
{
  const SectorMesh part     = sector(SectorForm::half);
  const SectorMesh together = whole_ring(part, MPI_COMM_WORLD),
                   alone    = whole_ring(part, MPI_COMM_SELF);
  ASSERT_LT(together.triangulation->n_locally_owned_active_cells(),
            alone.triangulation->n_locally_owned_active_cells());
  const CyclicSector ring(together, stator_materials(), 2),
      ring_alone(alone, stator_materials(), 2);
  RingSolver solver(ring), solver_alone(ring_alone);
  const ShiftWindow window      = solver_alone.window_around(4, 30e3);
  const std::vector<Mode> modes = solver.between(window), of_one = solver_alone.between(window);
  ASSERT_EQ(modes.size(), of_one.size());
  for (std::size_t i = 0; i < modes.size(); ++i)
    EXPECT_NEAR(modes[i].frequency() / of_one[i].frequency(), 1., 1e-10);
}
