// SPDX-License-Identifier: LGPL-2.1-or-later

// The compliance of a ring from that of one sector: a small ring, all of its sectors in one mesh
// without any symmetry, solved for forces on single nodes of several sectors, must move as the
// compliance of its condensed sectors predicts.

#include "support/block_ring.h"
#include "support/plane_surface.h"

#include <ringmotor/contact/ring_compliance.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace ringmotor;
using namespace ringmotor::tests;
using namespace ringmotor::tests::block_ring;

namespace
{
  /** Contact points that are the nodes of the surface. */
  MortarCoupling same_nodes(const unsigned int n_nodes)
  {
    MortarCoupling coupling;
    for (unsigned int node = 0; node < n_nodes; ++node)
      coupling.nodes.push_back({node, 1., {{node, 0, 1.}}});
    return coupling;
  }

  ByComponent motion_by_entries(const RingCompliance &ring, const ByComponent &forces)
  {
    const unsigned int n = ring.n_sectors(), width = 3 * ring.n_nodes();
    std::vector<unsigned int> nodes(ring.n_nodes());
    std::iota(nodes.begin(), nodes.end(), 0u);
    ByComponent motion(n, std::vector<double>(width, 0.));
    for (unsigned int distance = 0; distance < n; ++distance)
    {
      dealii::FullMatrix<double> entries(width, width);
      ring.add_entries(distance, nodes, nodes, 1., 0, entries, 0, 0);
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < width; ++i)
          for (unsigned int f = 0; f < width; ++f)
            motion[(j + distance) % n][i] += entries(i, f) * forces[j][f];
    }
    return motion;
  }

  ByComponent motion_of(const RingCompliance &ring, const ByComponent &forces)
  {
    const unsigned int n = ring.n_sectors(), width = 3 * ring.n_nodes();
    std::vector<double> all_forces, all(n * width, 0.);
    for (unsigned int j = 0; j < n; ++j)
      all_forces.insert(all_forces.end(), forces[j].begin(), forces[j].end());
    ring.add_motions(all_forces.data(), all.data());
    ByComponent motion;
    for (unsigned int j = 0; j < n; ++j)
      motion.emplace_back(all.begin() + j * width, all.begin() + (j + 1) * width);
    return motion;
  }

  /** Motions of all sectors but the first under forces on the first, computed from far shapes. */
  ByComponent motion_by_far(const RingCompliance &ring, const std::vector<double> &forces)
  {
    const RingCompliance::Far &far = ring.far();
    const unsigned int n_shapes    = far.shapes.n();
    dealii::Vector<double> of_shapes(n_shapes), by_shapes(n_shapes);
    for (unsigned int i = 0; i < forces.size(); ++i)
      for (unsigned int s = 0; s < n_shapes; ++s)
        of_shapes[s] += far.shapes(i, s) * forces[i];
    ByComponent motion(ring.n_sectors(), std::vector<double>(forces.size(), 0.));
    for (unsigned int d = 1; d < ring.n_sectors(); ++d)
    {
      far.kernel[d].vmult(by_shapes, of_shapes);
      for (unsigned int i = 0; i < forces.size(); ++i)
        for (unsigned int s = 0; s < n_shapes; ++s)
          motion[d][i] += far.shapes(i, s) * by_shapes[s];
    }
    return motion;
  }

  /** Generic forces on all sectors but one. */
  ByComponent some_forces(const unsigned int n_nodes)
  {
    ByComponent forces(n_sectors, std::vector<double>(3 * n_nodes, 0.));
    for (unsigned int j = 0; j < n_sectors; ++j)
      for (unsigned int i = 0; j != 2 && i < 3 * n_nodes; ++i)
        forces[j][i] = std::sin(1. + 37. * i + 11. * j * j);
    return forces;
  }

  void expect_same(const ByComponent &found, const ByComponent &expected,
                   const double tolerance = 1e-9)
  {
    double largest = 0., difference = 0.;
    for (unsigned int j = 0; j < expected.size(); ++j)
      for (unsigned int i = 0; i < expected[j].size(); ++i)
      {
        largest    = std::max(largest, std::abs(expected[j][i]));
        difference = std::max(difference, std::abs(found[j][i] - expected[j][i]));
      }
    EXPECT_LT(difference, tolerance * largest);
  }
} // namespace

class RingOfSectors : public testing::TestWithParam<SectorForm>
{
};

TEST_P(RingOfSectors, MovesAsTheWholeRing)
{
  const BlockSector body(GetParam());
  const auto &nodes         = body.surface.surface.nodes;
  const RingCompliance ring = body.ring(same_nodes(nodes.size()));
  RingCompliance table      = ring;
  table.tabulate();
  const ByComponent forces = some_forces(nodes.size());
  DirectRing direct;
  const ByComponent moved = direct.motion(nodes, forces);
  for (const RingCompliance *one : {&std::as_const(ring), &std::as_const(table)})
  {
    expect_same(motion_of(*one, forces), moved);
    expect_same(motion_by_entries(*one, forces), moved);
  }

  // Far shapes are fewer and describe the motion of other sectors almost completely.
  ByComponent on_first(n_sectors, std::vector<double>(3 * nodes.size(), 0.));
  on_first[0]         = forces[0];
  ByComponent on_rest = direct.motion(nodes, on_first);
  std::fill(on_rest[0].begin(), on_rest[0].end(), 0.);
  EXPECT_LT(ring.far().shapes.n(), 3 * nodes.size());
  expect_same(motion_by_far(ring, forces[0]), on_rest, 0.03);

  // Forces with a period of three sectors
  ByComponent repeated = forces;
  for (unsigned int j = 3; j < n_sectors; ++j)
    repeated[j] = repeated[j - 3];
  ByComponent expected = direct.motion(nodes, repeated);
  expected.resize(3);
  expect_same(motion_of(ring.folded(2), repeated), expected);
  expect_same(motion_of(table.folded(2), repeated), expected);
}

TEST_P(RingOfSectors, HasTheComplianceOfItsWaves)
{
  const BlockSector body(GetParam());
  const unsigned int n_nodes = body.surface.surface.nodes.size(), width = 3 * n_nodes;
  const RingCompliance ring = body.ring(same_nodes(n_nodes));
  const auto force          = [](const double i) { return std::polar(1. + std::sin(i), 5. * i); };
  for (unsigned int m = 0; 2 * m <= n_sectors; ++m)
  {
    const std::vector<std::complex<double>> of_wave = ring.of_wave(m);
    ByComponent forces(n_sectors, std::vector<double>(width)), expected = forces;
    for (unsigned int j = 0; j < n_sectors; ++j)
      for (unsigned int i = 0; i < width; ++i)
      {
        const auto phase = std::polar(1., m * j * pitch);
        forces[j][i]     = (force(i) * phase).real();
        for (unsigned int f = 0; f < width; ++f)
          expected[j][i] += (of_wave[f * width + i] * force(f) * phase).real();
      }
    expect_same(motion_of(ring, forces), expected);
  }
}

TEST_P(RingOfSectors, MovesTeethThatDoNotMatchItsMesh)
{
  const BlockSector body(GetParam());
  const ContactSurface &rotor = body.surface.surface;
  const ContactSurface tooth  = plane_surface({31e-3, 32.5e-3, 34e-3}, {-0.3, 0.15, 0.3}, 2);
  DirectRing direct;
  for (const double shift : {0., 0.4 * pitch, -0.3 * pitch})
  {
    const MortarCoupling coupling = couple(tooth, rotor, pitch, shift);
    ASSERT_EQ(coupling.nodes.size(), tooth.nodes.size());
    const RingCompliance ring = body.ring(coupling);
    const ByComponent forces  = some_forces(tooth.nodes.size());

    // Shares of the forces on the rotor's nodes, and the same shares of their motions
    const auto for_each_share = [&](const auto &visit)
    {
      for (unsigned int j = 0; j < n_sectors; ++j)
        for (unsigned int a = 0; a < coupling.nodes.size(); ++a)
          for (const MortarCoupling::Weight &share : coupling.nodes[a].weights)
            for (unsigned int c = 0; c < 3; ++c)
              visit(j, 3 * a + c, (j + n_sectors + share.sector) % n_sectors,
                    3 * share.rotor_node + c, share.weight);
    };
    ByComponent on_rotor(n_sectors, std::vector<double>(3 * rotor.nodes.size(), 0.)),
        expected(n_sectors, std::vector<double>(3 * tooth.nodes.size(), 0.));
    for_each_share([&](const unsigned int j, const unsigned int i, const unsigned int rotor_sector,
                       const unsigned int rotor_i, const double weight)
                   { on_rotor[rotor_sector][rotor_i] += weight * forces[j][i]; });
    const ByComponent moved = direct.motion(rotor.nodes, on_rotor);
    for_each_share([&](const unsigned int j, const unsigned int i, const unsigned int rotor_sector,
                       const unsigned int rotor_i, const double weight)
                   { expected[j][i] += weight * moved[rotor_sector][rotor_i]; });
    expect_same(motion_of(ring, forces), expected);
    expect_same(motion_by_entries(ring, forces), expected);
  }
}

INSTANTIATE_TEST_SUITE_P(Form, RingOfSectors, testing::Values(SectorForm::half, SectorForm::whole),
                         [](const auto &info)
                         { return info.param == SectorForm::half ? "Half" : "Whole"; });

TEST(RingCompliance, AddsWhatHappensWithinSectors)
{
  SurfaceCompliance body;
  body.at_rest.reinit(6, 6);
  body.at_rest(0, 0) = 1.;
  RingCompliance ring(3, body, same_nodes(2), {});
  dealii::FullMatrix<double> within(6, 6);
  within(4, 2) = 5.; // the second node's tangential motion due to the first one's radial force
  ring.add_within_sectors(within);
  RingCompliance table = ring;
  table.tabulate();
  for (const RingCompliance &one : {ring, table})
    for (unsigned int distance = 0; distance < 3; ++distance)
    {
      dealii::FullMatrix<double> entries(6, 6);
      one.add_entries(distance, {0, 1}, {0, 1}, 1., 0, entries, 0, 0);
      EXPECT_NEAR(entries(0, 0), distance == 0 ? 1. : 0., 1e-12);
      EXPECT_NEAR(entries(4, 2), distance == 0 ? 5. : 0., 1e-12);
      // Only tangential components, twice over, elsewhere in a matrix
      dealii::FullMatrix<double> part(4, 5);
      one.add_entries(distance, {1}, {0}, -2., 1, part, 1, 2);
      EXPECT_NEAR(part(2, 4), distance == 0 ? -10. : 0., 1e-12);
    }
}
