// SPDX-License-Identifier: LGPL-2.1-or-later

// Locally refined sectors. On a mesh that is mirrored about theta = 0, half and whole sector remain
// the same problem, including hanging nodes on the cuts and the mirror plane, and must agree up to
// rounding. A finer mesh contains the coarser one's functions (same shape of the cells up to their
// quadratic approximation), so eigenvalues decrease.

#include "support/materials.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/structure/modes.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  using Where = bool (*)(const dealii::Point<3> &);

  SectorMesh refined_where(const SectorForm form, const Where &chosen)
  {
    const SectorGrading grading{0, 2, 0.1};
    SectorMesh mesh = make_sector(stator_body(StatorGeometry(), 90), form, grading, MPI_COMM_WORLD);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
    {
      const dealii::Point<3> x = cell->center();
      if (chosen({std::hypot(x[0], x[1]), std::abs(std::atan2(x[1], x[0])), x[2]}))
        cell->set_refine_flag();
    }
    mesh.triangulation->execute_coarsening_and_refinement();
    return mesh;
  }

  /** The lowest elastic modes, all below the shift. */
  std::vector<double> frequencies(ModeSolver &solver, const unsigned int k, const double shift)
  {
    std::vector<double> found;
    for (const Mode &mode : solver.below(k, shift))
      if (!mode.rigid)
        found.push_back(mode.frequency());
    return found;
  }

  bool has_hanging_nodes(const SectorMesh &mesh)
  {
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->has_children())
          return true;
    return false;
  }

  /** Cells by the (r, |theta|, z) of their centres. */
  struct Region
  {
    const char *name;
    Where chosen;
  };
  std::ostream &operator<<(std::ostream &out, const Region &region)
  {
    return out << region.name;
  }

  const double half_pitch = dealii::numbers::PI / 90;

  class HangingNodes : public testing::TestWithParam<Region>
  {
  };
} // namespace

TEST_P(HangingNodes, KeepHalfEqualToWhole)
{
  const SectorMesh half  = refined_where(SectorForm::half, GetParam().chosen);
  const SectorMesh whole = refined_where(SectorForm::whole, GetParam().chosen);
  ASSERT_TRUE(has_hanging_nodes(half));
  ASSERT_EQ(2 * half.triangulation->n_active_cells(), whole.triangulation->n_active_cells());
  const CyclicSector half_sector(half, stator_materials(), 2),
      whole_sector(whole, stator_materials(), 2);
  ModeSolver half_solver(half_sector), whole_solver(whole_sector);
  for (const unsigned int k : {0u, 1u, 7u, 45u})
  {
    // Not far above the modes compared: rounding errors are of the order of the shift.
    const double shift                 = half_solver.shift_above(k, 2, 0.);
    const std::vector<double> of_half  = frequencies(half_solver, k, shift);
    const std::vector<double> of_whole = frequencies(whole_solver, k, shift);
    ASSERT_GE(of_half.size(), 2u);
    ASSERT_EQ(of_half.size(), of_whole.size());
    for (unsigned int i = 0; i < of_half.size(); ++i)
      EXPECT_NEAR(of_half[i] / of_whole[i], 1., 1e-10) << "k = " << k << ", mode " << i;
  }
}

TEST_P(HangingNodes, LowerTheFrequencies)
{
  const SectorMesh coarse_mesh =
      refined_where(SectorForm::half, [](const dealii::Point<3> &) { return false; });
  const SectorMesh fine_mesh = refined_where(SectorForm::half, GetParam().chosen);
  const CyclicSector coarse_sector(coarse_mesh, stator_materials(), 2),
      fine_sector(fine_mesh, stator_materials(), 2);
  ModeSolver coarse_solver(coarse_sector), fine_solver(fine_sector);
  const double shift               = coarse_solver.shift_above(7, 4, 0.);
  const std::vector<double> coarse = frequencies(coarse_solver, 7, shift);
  const std::vector<double> fine   = frequencies(fine_solver, 7, shift);
  ASSERT_GE(fine.size(), coarse.size());
  for (unsigned int i = 0; i < coarse.size(); ++i)
  {
    EXPECT_LT(fine[i], coarse[i] * (1. - 1e-7)) << "mode " << i;
    EXPECT_GT(fine[i], coarse[i] * 0.97) << "mode " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Regions, HangingNodes,
    testing::Values(Region{"OnTheCut", [](const dealii::Point<3> &x)
                           { return x[1] > 0.8 * half_pitch && x[2] > 2e-3 && x[2] < 4.37e-3; }},
                    Region{"AtTheMirrorPlane", [](const dealii::Point<3> &x)
                           { return x[1] < 0.4 * half_pitch && x[2] > 4.37e-3; }},
                    Region{"Outside", [](const dealii::Point<3> &x) { return x[0] > 33e-3; }}),
    [](const auto &info) { return info.param.name; });
