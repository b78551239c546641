// SPDX-License-Identifier: LGPL-2.1-or-later

// The compliance of a ring from that of one sector: a small ring, all of its sectors in one mesh
// without any symmetry, solved for forces on single nodes of several sectors, must move as the
// compliance of its condensed sectors predicts.

#include "support/materials.h"
#include "support/plane_surface.h"

#include <ringmotor/contact/ring_compliance.h>
#include <ringmotor/structure/cyclic_factors.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  constexpr unsigned int n_sectors = 6;
  constexpr double pitch           = 2. * dealii::numbers::PI / n_sectors;
  constexpr double base = -1e-3, clamp = 4e-3; ///< m, heights of lower face and of clamped faces

  /** A ring with a block on each sector: cells of these widths in theta, in parts of the pitch,
   * from an angle on. */
  void make_blocks(dealii::Triangulation<3> &triangulation, std::vector<double> around,
                   const double from)
  {
    for (double &part : around)
      part *= pitch;
    const std::vector<double> radial{3e-3, 2e-3}, axial{2e-3, 3e-3};
    dealii::Table<3, dealii::types::material_id> materials(2, around.size(), 2);
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < around.size(); ++j)
      {
        materials(i, j, 0) = ids::base;
        materials(i, j, 1) =
            around[j] > 0.25 * pitch ? ids::tooth : dealii::numbers::invalid_material_id;
      }
    dealii::GridGenerator::subdivided_hyper_rectangle(triangulation, {radial, around, axial},
                                                      Point<3>(30e-3, from, base), materials);
    dealii::GridTools::transform(
        [](const Point<3> &x)
        { return Point<3>(x[0] * std::cos(x[1]), x[0] * std::sin(x[1]), x[2]); },
        triangulation);
  }

  /** The lower face can touch, the blocks are clamped. */
  void complete(SectorMesh &mesh)
  {
    const bool is_half = mesh.form == SectorForm::half;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
        {
          const Point<3> x = face->center();
          const auto at    = [](const double a, const double b) { return std::abs(a - b) < 1e-9; };
          // The middle of a straight-sided face on a cut has the angle of the cut.
          const double theta = mesh.has_cuts ? std::atan2(x[1], x[0]) : 0.1 * pitch;
          face->set_boundary_id(at(x[2], base)            ? ids::lip
                                : at(x[2], clamp)         ? ids::clamped
                                : at(theta, 0.)           ? ids::mirror
                                : at(theta, 0.5 * pitch)  ? (is_half ? ids::cut : ids::cut_high)
                                : at(theta, -0.5 * pitch) ? ids::cut_low
                                                          : ids::free);
        }
    mesh.triangulation->set_all_manifold_ids(0);
    mesh.triangulation->set_manifold(0, dealii::CylindricalManifold<3>(2));
  }

  SectorMesh block_sector(const SectorForm form)
  {
    SectorMesh mesh{empty_triangulation<3>(MPI_COMM_SELF), form, n_sectors};
    if (form == SectorForm::half)
      make_blocks(*mesh.triangulation, {0.3, 0.2}, 0.);
    else
      make_blocks(*mesh.triangulation, {0.2, 0.3, 0.3, 0.2}, -0.5 * pitch);
    complete(mesh);
    return mesh;
  }

  SectorMesh block_ring()
  {
    SectorMesh mesh{empty_triangulation<3>(MPI_COMM_SELF), SectorForm::whole, 1, false};
    std::vector<dealii::Triangulation<3>> sectors(n_sectors);
    std::vector<const dealii::Triangulation<3> *> parts;
    for (unsigned int j = 0; j < n_sectors; ++j)
    {
      make_blocks(sectors[j], {0.2, 0.3, 0.3, 0.2}, (j - 0.5) * pitch);
      parts.push_back(&sectors[j]);
    }
    dealii::GridGenerator::merge_triangulations(parts, *mesh.triangulation, 1e-9);
    complete(mesh);
    return mesh;
  }

  /** Forces or motions by sector, three per node. */
  using ByComponent = std::vector<std::vector<double>>;

  /** The whole ring, without any use of its symmetry. */
  class DirectRing
  {
  public:
    DirectRing() : mesh(block_ring()), sector(mesh, all_of(steel), 2), factors(sector)
    {
      factors.factorise(0, 0.);
    }

    /** Motions of nodes at these positions (of sector 0) under forces on them. */
    ByComponent motion(const std::vector<SurfaceNode> &nodes, const ByComponent &forces)
    {
      SectorMotion loads = sector.at_rest();
      for_each(nodes,
               [&](const unsigned int j, const unsigned int i,
                   const std::array<SectorNodes::Dof, 3> &dofs, const double c, const double s)
               {
                 const double *f = forces[j].data() + 3 * i;
                 loads.solid.real[dofs[0]] += f[2] * c + f[1] * s;
                 loads.solid.real[dofs[1]] += f[2] * s - f[1] * c;
                 loads.solid.real[dofs[2]] += f[0];
               });
      std::vector<double> unknowns = sector.loads_of(0, loads);
      factors.solve(unknowns);
      const dealii::Vector<double> u = sector.expand(0, unknowns).solid.real;
      ByComponent motions(n_sectors, std::vector<double>(3 * nodes.size()));
      for_each(nodes,
               [&](const unsigned int j, const unsigned int i,
                   const std::array<SectorNodes::Dof, 3> &dofs, const double c, const double s)
               {
                 motions[j][3 * i]     = u[dofs[2]];
                 motions[j][3 * i + 1] = u[dofs[0]] * s - u[dofs[1]] * c;
                 motions[j][3 * i + 2] = u[dofs[0]] * c + u[dofs[1]] * s;
               });
      return motions;
    }

  private:
    template <typename Visit>
    void for_each(const std::vector<SurfaceNode> &nodes, const Visit &visit) const
    {
      for (unsigned int j = 0; j < n_sectors; ++j)
        for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          const double theta = nodes[i].place[1] + j * pitch;
          const double c = std::cos(theta), s = std::sin(theta);
          const Point<3> x(nodes[i].place[0] * c, nodes[i].place[0] * s, base);
          unsigned int node = 0;
          while (sector.nodes().position(node).distance(x) > 1e-9)
            ++node;
          visit(j, i,
                {{sector.nodes().dof(node, 0), sector.nodes().dof(node, 1),
                  sector.nodes().dof(node, 2)}},
                c, s);
        }
    }

    SectorMesh mesh;
    CyclicSector sector;
    CyclicFactors factors;
  };

  /** Condensed, from one sector. */
  struct BlockSector
  {
    SectorMesh mesh;
    CyclicSector sector;
    ContactSurface meshed;
    SectorSurface surface;
    Condensation condensation;
    InterfaceCompliance interface;

    explicit BlockSector(const SectorForm form)
        : mesh(block_sector(form)), sector(mesh, all_of(steel), 2),
          meshed(solid_surface(sector, ids::lip)), surface(whole_surface(meshed, form)),
          condensation(sector, displacement_forms(meshed), {}, {}, 0.), interface(condensation)
    {
    }

    RingCompliance ring(const MortarCoupling &coupling) const
    {
      return RingCompliance(n_sectors, sector_compliance(interface, surface.origin), coupling,
                            [&](const unsigned int k) { return interface.through_cut(k, {}); });
    }
  };

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
