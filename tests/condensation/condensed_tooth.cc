// SPDX-License-Identifier: LGPL-2.1-or-later

// A single tooth with prescribed motion of its foot. If the foot moves as a rigid body, so does the
// tooth; if it moves as a bending wave, or if forces act on the top, statically and vibrating, the
// motion of the top is compared with one sparse factorisation of all unknowns, bordered by the
// conditions on the foot.

#include "support/direct_sector.h"

#include <ringmotor/condensation/interface_compliance.h>
#include <ringmotor/contact/contact_surface.h>
#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/mesh/ids.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <set>
#include <vector>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;
using Complex = std::complex<double>;

namespace
{
  constexpr unsigned int n_teeth = 90;
  const Material aluminium{68.9e9, 0.33, 2700., 0.};

  /** Half of a tooth with prescribed motion of its foot. */
  struct Tooth
  {
    SectorMesh mesh = make_contact_tooth(stator_body(StatorGeometry(), n_teeth), 33.2e-3, 34.2e-3,
                                         {2, 2}, MPI_COMM_WORLD);
    CyclicSector sector{mesh, {{ids::tooth, aluminium}}, 2};
    ContactSurface top = solid_surface(sector, ids::tooth_top);
    std::vector<SectorNodes::Dof> driven;

    Tooth()
    {
      for (const SurfaceNode &node : solid_surface(sector, ids::tooth_foot).nodes)
        for (const auto &[dof, coefficient] : node.displacement[0])
          driven.push_back(dof);
    }

    /** Values of a Cartesian motion at the driven degrees of freedom, of the real field, then of
     * the imaginary one. */
    template <typename Motion>
    std::vector<double> at_foot(const Motion &motion) const
    {
      std::vector<double> values(2 * driven.size());
      for (unsigned int i = 0; i < driven.size(); ++i)
      {
        const SectorNodes &nodes  = sector.nodes();
        const auto u              = motion(nodes.position(nodes.node(driven[i])));
        const auto along          = nodes.direction(driven[i]);
        values[i]                 = u.first * along;
        values[driven.size() + i] = u.second * along;
      }
      return values;
    }
  };

  using RealAndImaginary = std::pair<dealii::Tensor<1, 3>, dealii::Tensor<1, 3>>;

  /** A rigid motion that equals the complex conjugate of its mirror image at y = 0. */
  RealAndImaginary rigid_motion(const Point<3> &x)
  {
    return {dealii::Tensor<1, 3>({1. + 90. * x[2], 0., -2. - 90. * x[0]}),
            dealii::Tensor<1, 3>({-150. * x[1], 0.5 + 150. * x[0] - 40. * x[2], 40. * x[1]})};
  }

  /** A bending wave of the same symmetry. */
  RealAndImaginary bending_wave(const Point<3> &x)
  {
    const double theta = std::atan2(x[1], x[0]), r = std::hypot(x[0], x[1]);
    const Complex wave = std::polar(1., -7. * theta), around = Complex(0., 2.) * wave;
    const std::array<Complex, 3> u{{0.3 * wave * std::cos(theta) - around * std::sin(theta),
                                    0.3 * wave * std::sin(theta) + around * std::cos(theta),
                                    300. * (r - 0.02) * wave}};
    return {dealii::Tensor<1, 3>({u[0].real(), u[1].real(), u[2].real()}),
            dealii::Tensor<1, 3>({u[0].imag(), u[1].imag(), u[2].imag()})};
  }
} // namespace

TEST(CondensedTooth, CarriesARigidMotionFromFootToTop)
{
  const Tooth tooth;
  const Condensation condensation(tooth.sector, displacement_forms(tooth.top), tooth.driven, {},
                                  0.);
  const std::vector<double> moved =
      condensation.prescribed_response(0, tooth.at_foot(rigid_motion));
  const unsigned int n = tooth.top.nodes.size();
  ASSERT_GT(n, 4u);
  ASSERT_EQ(moved.size(), 6 * n);
  const double top = StatorGeometry().base_thickness + StatorGeometry().tooth_height;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double r = tooth.top.nodes[i].place[0], theta = tooth.top.nodes[i].place[1];
    const double c = std::cos(theta), s = std::sin(theta);
    const auto [real, imaginary] = rigid_motion(Point<3>(r * c, r * s, top));
    for (const unsigned int part : {0u, 1u})
    {
      const auto &u      = part == 0 ? real : imaginary;
      const double *node = moved.data() + part * 3 * n + 3 * i;
      EXPECT_NEAR(node[0], u[2], 1e-9);
      EXPECT_NEAR(node[1], u[0] * s - u[1] * c, 1e-9);
      EXPECT_NEAR(node[2], u[0] * c + u[1] * s, 1e-9);
    }
  }
}

TEST(CondensedTooth, CarriesAWaveFromFootToTopAsASolutionWithAllUnknownsDoes)
{
  const Tooth tooth;
  const std::vector<LinearForm> forms = displacement_forms(tooth.top);
  for (const double shift : {0., std::pow(2. * M_PI * 40e3, 2)})
  {
    const Condensation condensation(tooth.sector, forms, tooth.driven, {}, shift, true);
    const std::vector<double> given = tooth.at_foot(bending_wave);
    const std::vector<double> moved = condensation.prescribed_response(0, given);
    const dealii::FullMatrix<double> compliance =
        InterfaceCompliance(condensation).compliance(0, {});

    // Conditions u = given for each unconstrained driven degree of freedom
    std::vector<std::vector<double>> conditions;
    std::vector<double> load(tooth.sector.n_unknowns(), 0.);
    for (const unsigned int part : {0u, 1u})
      for (unsigned int i = 0; i < tooth.driven.size(); ++i)
      {
        const std::vector<double> row =
            loads_of_form(tooth.sector, 0, part, {{tooth.driven[i], 1.}});
        if (std::all_of(row.begin(), row.end(), [](const double entry) { return entry == 0.; }))
        {
          EXPECT_NEAR(given[part * tooth.driven.size() + i], 0., 1e-15);
          continue;
        }
        conditions.push_back(row);
        load.push_back(given[part * tooth.driven.size() + i]);
      }
    DirectSector direct(tooth.sector, 0, shift, conditions);
    std::vector<double> solution = direct.solve(load);
    solution.resize(tooth.sector.n_unknowns());
    expect_motion(condensation.interior(0, {}, {{{}, given, {}}}).front(),
                  tooth.sector.expand(0, solution), 1e-9);
    std::vector<std::vector<double>> loads;
    for (const unsigned int part : {0u, 1u})
      for (const LinearForm &form : forms)
        loads.push_back(loads_of_form(tooth.sector, 0, part, form));
    for (unsigned int i = 0; i < loads.size(); ++i)
      EXPECT_NEAR(moved[i],
                  std::inner_product(loads[i].begin(), loads[i].end(), solution.begin(), 0.), 1e-9);
    expect_solutions(
        compliance, loads, [&](const std::vector<double> &force) { return direct.solve(force); },
        1e-9);
  }
}

TEST(ContactSurface, TakesTheWideFacesOfLongTeeth)
{
  // Slots with parallel walls are curved in (r, theta): nodes in the middle of faces that are long
  // in r are not where the corners have them.
  StatorGeometry geometry;
  geometry.base_inner_radius = geometry.tip_inner_radius = 33.88e-3;
  geometry.base_outer_radius = geometry.tip_outer_radius = 45.15e-3;
  geometry.slot_width                                    = 1.2e-3;
  const SectorMesh mesh =
      make_contact_tooth(stator_body(geometry, 87), 42.98e-3, 45.15e-3, {2, 2}, MPI_COMM_WORLD);
  const CyclicSector sector{mesh, {{ids::tooth, aluminium}}, 3};
  const ContactSurface foot = solid_surface(sector, ids::tooth_foot);
  for (const std::vector<unsigned int> &face : foot.faces)
    EXPECT_EQ(std::set<unsigned int>(face.begin(), face.end()).size(), 16u);
  // At the place of each node, which differs from that on the unit face by 4 %, it has nearly all
  // of the weight.
  for (unsigned int node = 0; node < foot.nodes.size(); ++node)
  {
    double own = 0.;
    for (const auto &[other, weight] : interpolation(foot, foot.nodes[node].place))
      own += other == node ? weight : 0.;
    EXPECT_NEAR(own, 1., 0.25) << node;
  }
}
