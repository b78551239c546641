// SPDX-License-Identifier: LGPL-2.1-or-later

// The cyclic sector against the whole ring on the same mesh: N rotated copies of the sector, merged
// into one body without any symmetry, solved as an ordinary eigenproblem. Its spectrum is the union
// of those of the nodal diameters 0 .. N/2, those between 0 and N/2 twice (cosine and sine mode).

#include "support/materials.h"
#include "support/plain_problem.h"
#include "support/record.h"

#include <ringmotor/structure/modes.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;
using dealii::Triangulation;

namespace
{
  constexpr unsigned int n_sectors = 6;
  constexpr double pitch           = 2. * dealii::numbers::PI / n_sectors;

  /** Ceramic ring, metal ring and a tooth: one whole sector, rotated by @p angle. */
  void make_toothed_sector(Triangulation<3> &triangulation, const double angle)
  {
    const std::vector<double> radial{3e-3, 3e-3}, around{0.2 * pitch, 0.6 * pitch, 0.2 * pitch},
        axial{1e-3, 4e-3, 3e-3};
    dealii::Table<3, dealii::types::material_id> materials(2, 3, 3);
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 3; ++j)
      {
        materials(i, j, 0) = ids::piezoceramic;
        materials(i, j, 1) = ids::base;
        materials(i, j, 2) = j == 1 ? ids::tooth : dealii::numbers::invalid_material_id;
      }
    dealii::GridGenerator::subdivided_hyper_rectangle(triangulation, {radial, around, axial},
                                                      Point<3>(30e-3, angle - 0.5 * pitch, -1e-3),
                                                      materials);
    dealii::GridTools::transform(
        [](const Point<3> &x)
        { return Point<3>(x[0] * std::cos(x[1]), x[0] * std::sin(x[1]), x[2]); },
        triangulation);
  }

  void curve(Triangulation<3> &triangulation)
  {
    triangulation.set_all_manifold_ids(0);
    triangulation.set_manifold(0, dealii::CylindricalManifold<3>(2));
  }

  SectorMesh one_sector()
  {
    SectorMesh mesh{empty_triangulation<3>(MPI_COMM_WORLD), SectorForm::whole, n_sectors};
    make_toothed_sector(*mesh.triangulation, 0.);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
        {
          // The middle of a straight-sided face on a cut has the angle of the cut.
          const double theta = std::atan2(face->center()[1], face->center()[0]);
          face->set_boundary_id(theta > 0.499 * pitch    ? ids::cut_high
                                : theta < -0.499 * pitch ? ids::cut_low
                                                         : ids::free);
        }
    curve(*mesh.triangulation);
    return mesh;
  }

  void make_full_ring(Triangulation<3> &ring)
  {
    std::vector<Triangulation<3>> sectors(n_sectors);
    std::vector<const Triangulation<3> *> parts;
    for (unsigned int sector = 0; sector < n_sectors; ++sector)
    {
      make_toothed_sector(sectors[sector], sector * pitch);
      parts.push_back(&sectors[sector]);
    }
    dealii::GridGenerator::merge_triangulations(parts, ring, 1e-9);
    curve(ring);
  }

  bool nothing_is_fixed(unsigned int, const Point<3> &)
  {
    return false;
  }

  bool is_double(const unsigned int k)
  {
    return k != 0 && 2 * k != n_sectors;
  }

  /** Frequencies of all elastic modes below @p limit (Hz), ascending, doubles twice. */
  std::vector<double> union_of_nodal_diameters(ModeSolver &solver, const double limit)
  {
    std::vector<double> all;
    for (unsigned int k = 0; k <= n_sectors / 2; ++k)
      for (const Mode &mode : solver.below(k, squared_rate(limit)))
        if (!mode.rigid)
          all.insert(all.end(), is_double(k) ? 2 : 1, mode.frequency());
    std::sort(all.begin(), all.end());
    return all;
  }
} // namespace

TEST(FullRing, HasTheUnionOfAllNodalDiametersAsItsSpectrum)
{
  Triangulation<3> ring;
  make_full_ring(ring);
  const SectorMesh mesh = one_sector();
  ASSERT_EQ(ring.n_active_cells(), n_sectors * mesh.triangulation->n_active_cells());
  const CyclicSector sector(mesh, stator_materials(), 2);
  ModeSolver solver(sector);
  const PlainProblem plain(ring, stator_materials(), 2, nothing_is_fixed);

  const double limit                 = 60e3;
  const std::vector<double> expected = union_of_nodal_diameters(solver, limit);
  ASSERT_GT(expected.size(), 20u);
  EXPECT_EQ(plain.count_below(squared_rate(limit)), expected.size() + 6);

  // Above the rigid motions, in the middle of the elastic modes: all of them are near.
  std::vector<double> found = plain.nearest(squared_rate(0.6 * limit), expected.size() + 6);
  found.erase(found.begin(), found.begin() + 6);
  double largest = 0.;
  for (unsigned int i = 0; i < expected.size(); ++i)
  {
    largest = std::max(largest, std::abs(frequency_of(found[i]) / expected[i] - 1.));
    EXPECT_NEAR(frequency_of(found[i]), expected[i], 1e-8 * expected[i]) << "mode " << i;
  }
  record("largest relative difference of frequencies", largest);

  // Cosine against sine mode
  unsigned int n_pairs = 0;
  double between       = 0.;
  for (unsigned int i = 0; i + 1 < expected.size(); ++i)
    if (expected[i] == expected[i + 1])
    {
      between = std::max(between, std::abs(found[i] / found[i + 1] - 1.));
      EXPECT_NEAR(found[i] / found[i + 1], 1., 2e-9) << "mode " << i;
      ++n_pairs;
    }
  EXPECT_GT(n_pairs, 8u);
  record("largest relative difference of cosine and sine modes (squared frequencies)", between);
}

TEST(FullRing, CountsTheModesOfAllNodalDiameters)
{
  // Sylvester's law on the whole ring against the Sturm counts of the nodal diameters
  Triangulation<3> ring;
  make_full_ring(ring);
  const SectorMesh mesh = one_sector();
  const CyclicSector sector(mesh, stator_materials(), 2);
  ModeSolver solver(sector);
  const PlainProblem plain(ring, stator_materials(), 2, nothing_is_fixed);
  for (const double frequency : {1e3, 20e3, 100e3, 400e3})
  {
    unsigned int sum = 0;
    for (unsigned int k = 0; k <= n_sectors / 2; ++k)
      sum += (is_double(k) ? 2 : 1) * solver.count_below(k, squared_rate(frequency));
    EXPECT_EQ(plain.count_below(squared_rate(frequency)), sum) << frequency << " Hz";
  }
}
