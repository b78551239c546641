// SPDX-License-Identifier: LGPL-2.1-or-later

// The output of a mode: the sampled sector and the traces on its surfaces. The wave's symmetry is
// the reference: the sector turned by alpha continues it with the phase exp(-i n alpha), and half
// sector (completed by its mirror image) and whole sector show the same wave.

#include "support/materials.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/pictures/sector_field.h>
#include <ringmotor/pictures/surface_trace.h>
#include <ringmotor/wave/energy.h>
#include <ringmotor/wave/tooth_motion.h>

#include <deal.II/base/tensor.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  constexpr unsigned int n_teeth = 90, n_waves = 7;
  const double alpha = 2. * M_PI / n_teeth;

  using Motion = std::array<std::complex<double>, 3>;
  using Place  = std::tuple<long, long, long>;

  /** A position to 1 nm. */
  Place place(const Point<3> &x)
  {
    return {std::lround(1e9 * x[0]), std::lround(1e9 * x[1]), std::lround(1e9 * x[2])};
  }

  Motion cylindrical(const Point<3> &x, const Motion &u)
  {
    const double r = std::hypot(x[0], x[1]), c = x[0] / r, s = x[1] / r;
    return {{c * u[0] + s * u[1], c * u[1] - s * u[0], u[2]}};
  }

  void expect_equal(const Motion &found, const Motion &expected)
  {
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_LT(std::abs(found[d] - expected[d]), 1e-7 * 2e-6);
  }

  /** The wave with 2 um amplitude on a coarse stator. */
  struct Wave
  {
    SectorMesh mesh;
    CyclicSector sector;
    Mode mode;

    explicit Wave(const SectorForm form, const StatorGeometry &stator = StatorGeometry())
        : mesh(make_sector(stator_body(stator, n_teeth), form, SectorGrading::level(1),
                           MPI_COMM_WORLD)),
          sector(mesh, stator_materials(), 2), mode(lowest())
    {
      normalise_to_amplitude(mode, tooth_points(sector), 2e-6);
    }

  private:
    Mode lowest() const
    {
      ModeSolver solver(sector);
      return solver.below(n_waves, solver.shift_above(n_waves, 2, 0.)).front();
    }
  };

  std::map<Place, Motion> cylindrical_motions(const SectorField &field)
  {
    std::map<Place, Motion> motions;
    for (const SectorField::Cell &cell : field.cells)
      for (unsigned int i = 0; i < cell.points.size(); ++i)
        motions[place(cell.points[i])] = cylindrical(cell.points[i], cell.displacement[i]);
    return motions;
  }

  /** The integral of the strain energy over the cells, from the corners of the lattice's boxes. */
  std::map<dealii::types::material_id, double> stored(const SectorField &field)
  {
    const unsigned int n = field.order + 1; // points of the lattice per direction
    std::map<dealii::types::material_id, double> energy;
    for (const SectorField::Cell &cell : field.cells)
      for (unsigned int box = 0; box < n * n * n; ++box)
      {
        if (box % n == n - 1 || box / n % n == n - 1 || box / (n * n) == n - 1)
          continue; // no box begins here
        double mean = 0.;
        std::array<dealii::Tensor<1, 3>, 3> edge; // means of four edges
        for (unsigned int corner = 0; corner < 8; ++corner)
        {
          const unsigned int i = box + corner % 2 + n * (corner / 2 % 2) + n * n * (corner / 4);
          mean += cell.strain_energy[i] / 8.;
          for (unsigned int d = 0; d < 3; ++d)
            edge[d] +=
                ((corner >> d) % 2 == 1 ? 0.25 : -0.25) * dealii::Tensor<1, 3>(cell.points[i]);
        }
        energy[cell.material] += mean * (edge[0] * dealii::cross_product_3d(edge[1], edge[2]));
      }
    return energy;
  }

  /** Compares strain energies with those of the matrices, by material. */
  void expect_energy(const CyclicSector &sector, const Mode &mode, const double tolerance)
  {
    const auto found          = stored(sample_sector(sector, mode, 16));
    const WaveEnergy expected = wave_energy(sector, mode);
    for (const auto &[material, energy] : expected.strain)
      EXPECT_NEAR(found.at(material) * n_teeth, energy, tolerance * energy) << int(material);
  }

  class Fields : public testing::TestWithParam<SectorForm>
  {
  };
} // namespace

TEST_P(Fields, GoOnInTheNextSector)
{
  const Wave wave(GetParam());
  const SectorField field = sample_sector(wave.sector, wave.mode, 2);
  EXPECT_EQ(field.n_sectors, n_teeth);
  EXPECT_EQ(field.nodal_diameter, n_waves);
  EXPECT_NEAR(field.angular_frequency, std::sqrt(wave.mode.eigenvalue), 1e-6);
  const auto motions   = cylindrical_motions(field);
  unsigned int n_pairs = 0;
  for (const SectorField::Cell &cell : field.cells)
    for (const Point<3> &x : cell.points)
      if (std::abs(std::atan2(x[1], x[0]) + 0.5 * alpha) < 1e-9)
      {
        const Point<3> turned(std::cos(alpha) * x[0] - std::sin(alpha) * x[1],
                              std::sin(alpha) * x[0] + std::cos(alpha) * x[1], x[2]);
        Motion expected = motions.at(place(x));
        for (std::complex<double> &component : expected)
          component *= std::polar(1., -static_cast<double>(n_waves) * alpha);
        expect_equal(motions.at(place(turned)), expected);
        ++n_pairs;
      }
  EXPECT_GT(n_pairs, 20u);
}

TEST_P(Fields, AreSampledOnRightHandedCells)
{
  const Wave wave(GetParam());
  for (const SectorField::Cell &cell : sample_sector(wave.sector, wave.mode, 1).cells)
  {
    const auto &p = cell.points;
    ASSERT_EQ(p.size(), 8u);
    EXPECT_GT((p[1] - p[0]) * dealii::cross_product_3d(p[2] - p[0], p[4] - p[0]), 0.);
  }
}

TEST_P(Fields, StoreTheStrainEnergyOfTheWave)
{
  const Wave wave(GetParam());
  expect_energy(wave.sector, wave.mode, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Forms, Fields, testing::Values(SectorForm::half, SectorForm::whole),
                         [](const auto &info)
                         { return info.param == SectorForm::half ? "Half" : "Whole"; });

TEST(Field, StoresTheStrainEnergyOfAShell)
{
  StatorGeometry stator;
  stator.piezoceramic_element = ElementKind::shell;
  const Wave wave(SectorForm::half, stator);
  expect_energy(wave.sector, wave.mode, 0.005);
}

TEST(Field, IsTheSameOfHalfAndWholeSector)
{
  const Wave half(SectorForm::half), whole(SectorForm::whole);
  const auto of_half  = cylindrical_motions(sample_sector(half.sector, half.mode, 2));
  const auto of_whole = cylindrical_motions(sample_sector(whole.sector, whole.mode, 2));
  ASSERT_EQ(of_half.size(), of_whole.size());
  for (const auto &[where, motion] : of_half)
  {
    ASSERT_EQ(of_whole.count(where), 1u);
    expect_equal(of_whole.at(where), motion);
  }
}

TEST(SurfaceTrace, IsTheSectorsFieldOnItsSurfaces)
{
  const StatorGeometry stator;
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    const Wave wave(form);
    const auto motions = cylindrical_motions(sample_sector(wave.sector, wave.mode, 2));
    for (const auto &[surface, height] :
         {std::pair(Surface::tooth_top, stator.base_thickness + stator.tooth_height),
          std::pair(Surface::tooth_foot, stator.base_thickness),
          std::pair(Surface::bottom, -stator.piezoceramic_thickness)})
    {
      const SurfaceTrace trace = surface_trace(wave.sector, wave.mode, surface);
      EXPECT_EQ(trace.order, 2u);
      EXPECT_GT(trace.n_faces, 3u);
      ASSERT_EQ(trace.points.size(), trace.n_faces * 9);
      ASSERT_EQ(trace.displacement.size(), trace.points.size());
      double least = 0., most = 0.; // angles
      for (unsigned int i = 0; i < trace.points.size(); ++i)
      {
        const Point<3> &x = trace.points[i];
        EXPECT_NEAR(x[2], height, 1e-12);
        expect_equal(trace.displacement[i], motions.at(place(x)));
        least = std::min(least, std::atan2(x[1], x[0]));
        most  = std::max(most, std::atan2(x[1], x[0]));
      }
      const double edge =
          0.5 * alpha -
          (surface == Surface::bottom
               ? 0.
               : std::asin(0.5 * stator.slot_width /
                           (surface == Surface::tooth_top
                                ? stator.tip_outer_radius
                                : stator.base_outer_radius -
                                      stator.base_thickness /
                                          (stator.base_thickness + stator.tooth_height) *
                                          (stator.base_outer_radius - stator.tip_outer_radius))));
      EXPECT_NEAR(most, edge, 1e-12);
      EXPECT_NEAR(least, -edge, 1e-12);
    }
  }
}
