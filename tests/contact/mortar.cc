// SPDX-License-Identifier: LGPL-2.1-or-later

// The mortar coupling of non-matching surfaces against integrals by hand. Along theta, where the
// weight r has no effect, the dual functions of a linear face 0 <= s <= 1 are 2 - 3 s and 3 s - 1:
// with the rotor's hat functions at s = -3/4, 1/4, 5/4 they give integrals of 7, 66, -9 and
// -3, 22, 45 in units of 1/128. On grids along r and theta all integrals are products of those of
// one variable, here by Gauss points piece by piece; dual functions are built from polynomials of
// two variables in the one case and of one in the other. Properties: matching surfaces are coupled
// node by node (biorthogonality), weights add up to 1, and a function that both discretisations
// contain is transferred unchanged.

#include "support/geometry.h"
#include "support/plane_surface.h"

#include <ringmotor/contact/mortar.h>
#include <ringmotor/parameters/errors.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/lac/full_matrix.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  using Lines = std::vector<double>;

  /** One weight: rotor node and sector. */
  double weight(const MortarCoupling::Node &node, const unsigned int rotor_node, const int sector)
  {
    double sum = 0.;
    for (const MortarCoupling::Weight &entry : node.weights)
      if (entry.rotor_node == rotor_node && entry.sector == sector)
        sum += entry.weight;
    return sum;
  }

  /** The values at the coupling's nodes of a function of (r, theta) given at the rotor's nodes. */
  Lines seen(const MortarCoupling &coupling, const ContactSurface &rotor, const double pitch,
             const double shift, const std::function<double(double, double)> &function)
  {
    Lines values;
    for (const MortarCoupling::Node &node : coupling.nodes)
    {
      double sum = 0.;
      for (const MortarCoupling::Weight &entry : node.weights)
      {
        const Point<2> &place = rotor.nodes[entry.rotor_node].place;
        sum += entry.weight * function(place[0], place[1] + shift + entry.sector * pitch);
      }
      values.push_back(sum);
    }
    return values;
  }

  void expect_sums_of_one(const MortarCoupling &coupling)
  {
    for (const MortarCoupling::Node &node : coupling.nodes)
    {
      double sum = 0.;
      for (const MortarCoupling::Weight &entry : node.weights)
        sum += entry.weight;
      EXPECT_NEAR(sum, 1., 1e-12);
    }
  }
} // namespace

TEST(Mortar, HasTheWeightsOfLinearFacesByHand)
{
  const double h                = 0.01;
  const Lines radii             = {0.03, 0.031};
  const ContactSurface tooth    = plane_surface(radii, {0., h}, 1),
                       rotor    = plane_surface(radii, {-0.75 * h, 0.25 * h, 1.25 * h}, 1);
  const MortarCoupling coupling = couple(tooth, rotor, 3. * h);
  ASSERT_EQ(coupling.nodes.size(), 4u);
  const std::array<std::array<double, 3>, 2> expected{{{{7., 66., -9.}}, {{-3., 22., 45.}}}};
  for (const MortarCoupling::Node &node : coupling.nodes)
  {
    const unsigned int i = node.tooth_node / 2, j = node.tooth_node % 2; // across, around
    // integral of r over one of two linear functions of r, times h/2
    const double r_0 = radii[0], length = radii[1] - radii[0];
    const double area =
        0.5 * h * length * (i == 0 ? 0.5 * r_0 + length / 6. : 0.5 * r_0 + length / 3.);
    EXPECT_NEAR(node.area / area, 1., 1e-12);
    for (unsigned int k = 0; k < 6; ++k)
      EXPECT_NEAR(weight(node, k, 0), k / 3 == i ? expected[j][k % 3] / 64. : 0., 1e-12);
  }
}

TEST(Mortar, FindsTheNeighboursSectors)
{
  // The rotor's sector, advanced by a quarter of its only cell: a tooth then also overlaps the
  // previous sector, and no other.
  const double h             = 0.01;
  const Lines radii          = {0.03, 0.031};
  const ContactSurface tooth = plane_surface(radii, {0., h}, 1), &rotor = tooth;
  for (const MortarCoupling::Node &node : couple(tooth, rotor, h, 0.25 * h).nodes)
  {
    const unsigned int first = 2 * (node.tooth_node / 2); // of the nodes at this radius
    const bool lower         = node.tooth_node % 2 == 0;
    EXPECT_NEAR(weight(node, first, -1), (lower ? 7. : -3.) / 64., 1e-12);
    EXPECT_NEAR(weight(node, first + 1, -1) + weight(node, first, 0), (lower ? 66. : 22.) / 64.,
                1e-12);
    EXPECT_NEAR(weight(node, first + 1, 0), (lower ? -9. : 45.) / 64., 1e-12);
    for (unsigned int k = 0; k < 4; ++k)
      EXPECT_EQ(weight(node, k, 1), 0.);
  }
  // The other direction: three quarters of a cell later the same nodes belong to the next sector.
  for (const MortarCoupling::Node &node : couple(tooth, rotor, h, -0.75 * h).nodes)
  {
    const unsigned int first = 2 * (node.tooth_node / 2);
    EXPECT_NEAR(weight(node, first, 0), (node.tooth_node % 2 == 0 ? 7. : -3.) / 64., 1e-12);
    EXPECT_NEAR(weight(node, first + 1, 1), (node.tooth_node % 2 == 0 ? -9. : 45.) / 64., 1e-12);
    for (unsigned int k = 0; k < 4; ++k)
      EXPECT_EQ(weight(node, k, -1), 0.);
  }
}

namespace
{
  /** Coupling of lines: areas and integrals of dual functions times the other's functions. */
  struct LineCoupling
  {
    Lines area;
    dealii::FullMatrix<double> integrals;
  };

  LineCoupling couple_lines(const Lines &tooth, const Lines &rotor, const unsigned int tooth_degree,
                            const unsigned int rotor_degree,
                            const std::function<double(double)> &density)
  {
    using Polynomials = std::vector<dealii::Polynomials::Polynomial<double>>;
    const auto basis  = [](const unsigned int degree) -> Polynomials
    { return dealii::Polynomials::LagrangeEquidistant::generate_complete_basis(degree); };
    const Polynomials phi = basis(tooth_degree), chi = basis(rotor_degree);
    const unsigned int n = tooth_degree * (tooth.size() - 1) + 1,
                       m = rotor_degree * (rotor.size() - 1) + 1;
    LineCoupling coupling{Lines(n, 0.), dealii::FullMatrix<double>(n, m)};
    for (unsigned int e = 0; e + 1 < tooth.size(); ++e)
    {
      dealii::FullMatrix<double> mass(phi.size(), phi.size()), mixed(phi.size(), m);
      Lines area(phi.size(), 0.);
      const auto on_tooth = [&](const double x)
      { return (x - tooth[e]) / (tooth[e + 1] - tooth[e]); };
      for (unsigned int f = 0; f + 1 < rotor.size(); ++f)
      {
        const double from = std::max(tooth[e], rotor[f]), to = std::min(tooth[e + 1], rotor[f + 1]);
        if (from >= to)
          continue;
        for (unsigned int i = 0; i < phi.size(); ++i)
        {
          const auto shape = [&](const double x) { return density(x) * phi[i].value(on_tooth(x)); };
          area[i] += integral(shape, from, to);
          for (unsigned int j = 0; j < phi.size(); ++j)
            mass(i, j) += integral(
                [&](const double x) { return shape(x) * phi[j].value(on_tooth(x)); }, from, to);
          for (unsigned int j = 0; j < chi.size(); ++j)
            mixed(i, rotor_degree * f + j) += integral(
                [&](const double x)
                { return shape(x) * chi[j].value((x - rotor[f]) / (rotor[f + 1] - rotor[f])); },
                from, to);
        }
      }
      mass.gauss_jordan();
      dealii::FullMatrix<double> dual(phi.size(), m);
      mass.mmult(dual, mixed);
      for (unsigned int i = 0; i < phi.size(); ++i)
      {
        coupling.area[tooth_degree * e + i] += area[i];
        for (unsigned int j = 0; j < m; ++j)
          coupling.integrals(tooth_degree * e + i, j) += area[i] * dual(i, j);
      }
    }
    return coupling;
  }

  class MortarDegrees : public testing::TestWithParam<std::pair<unsigned int, unsigned int>>
  {
  protected:
    const unsigned int tooth_degree = GetParam().first, rotor_degree = GetParam().second;
  };
} // namespace

TEST_P(MortarDegrees, HaveTheIntegralsOfOneVariable)
{
  // Strongly different radii: the weight r matters. Neither surface covers the other.
  const Lines tooth_r{0.010, 0.013, 0.020}, rotor_r{0.008, 0.0117, 0.0155, 0.021};
  const Lines tooth_t{-0.02, 0.003, 0.02}, rotor_t{-0.03, -0.011, -0.004, 0.013, 0.03};
  const LineCoupling across =
      couple_lines(tooth_r, rotor_r, tooth_degree, rotor_degree, [](const double r) { return r; });
  const LineCoupling around =
      couple_lines(tooth_t, rotor_t, tooth_degree, rotor_degree, [](double) { return 1.; });
  const unsigned int n_t = around.integrals.m(), m_t = around.integrals.n();

  const MortarCoupling coupling = couple(plane_surface(tooth_r, tooth_t, tooth_degree),
                                         plane_surface(rotor_r, rotor_t, rotor_degree), 0.06);
  ASSERT_EQ(coupling.nodes.size(), across.area.size() * around.area.size());
  for (const MortarCoupling::Node &node : coupling.nodes)
  {
    const unsigned int i = node.tooth_node / n_t, j = node.tooth_node % n_t;
    const double area = across.area[i] * around.area[j];
    EXPECT_NEAR(node.area / area, 1., 1e-12);
    for (unsigned int k = 0; k < across.integrals.n(); ++k)
      for (unsigned int l = 0; l < m_t; ++l)
        EXPECT_NEAR(weight(node, k * m_t + l, 0),
                    across.integrals(i, k) * around.integrals(j, l) / area, 2e-12);
  }
  expect_sums_of_one(coupling);
}

TEST_P(MortarDegrees, CarryOverWhatBothSurfacesContain)
{
  const double pitch = 0.05;
  const ContactSurface tooth =
                           plane_surface({0.03, 0.0303, 0.031}, {-0.02, 0.004, 0.02}, tooth_degree),
                       rotor =
                           plane_surface({0.0295, 0.0304, 0.0306, 0.0315},
                                         {-0.5 * pitch, -0.01, 0.012, 0.5 * pitch}, rotor_degree);
  const unsigned int degree = std::min(tooth_degree, rotor_degree);
  const auto function       = [&](const double r, const double theta)
  {
    const double x = (r - 0.0305) / 1e-3, y = theta / pitch;
    return 1. + 2. * x - 3. * y + 0.5 * x * y + (degree > 1 ? x * x * (1. + y) - 2. * y * y : 0.);
  };
  for (const double shift : {0., 0.13 * pitch, -0.3 * pitch, 0.5 * pitch})
  {
    const MortarCoupling coupling = couple(tooth, rotor, pitch, shift);
    ASSERT_EQ(coupling.nodes.size(), tooth.nodes.size());
    expect_sums_of_one(coupling);
    const Lines values = seen(coupling, rotor, pitch, shift, function);
    for (unsigned int i = 0; i < values.size(); ++i)
    {
      const Point<2> &place = tooth.nodes[coupling.nodes[i].tooth_node].place;
      EXPECT_NEAR(values[i], function(place[0], place[1]), 2e-12) << shift;
    }
  }
}

TEST_P(MortarDegrees, MatchNodeByNode)
{
  const ContactSurface surface =
      plane_surface({0.03, 0.0303, 0.031}, {-0.02, 0.004, 0.02}, tooth_degree);
  const MortarCoupling coupling = couple(surface, surface, 0.05);
  ASSERT_EQ(coupling.nodes.size(), surface.nodes.size());
  double area = 0.;
  for (const MortarCoupling::Node &node : coupling.nodes)
  {
    area += node.area;
    for (unsigned int other = 0; other < surface.nodes.size(); ++other)
      EXPECT_NEAR(weight(node, other, 0), other == node.tooth_node ? 1. : 0., 1e-12);
  }
  EXPECT_NEAR(area / (0.5 * 0.04 * (0.031 * 0.031 - 0.03 * 0.03)), 1., 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Degrees, MortarDegrees,
                         testing::Values(std::pair(1u, 1u), std::pair(2u, 2u), std::pair(1u, 2u),
                                         std::pair(2u, 1u)),
                         [](const auto &info)
                         {
                           return "Tooth" + std::to_string(info.param.first) + "Rotor" +
                                  std::to_string(info.param.second);
                         });

TEST(Mortar, KnowsHowFarFacesAreCovered)
{
  // Of two linear faces of the tooth the rotor covers 0.6 of the first and none of the second.
  const double h                = 0.01;
  const Lines radii             = {0.03, 0.031};
  const ContactSurface tooth    = plane_surface(radii, {0., h, 2. * h}, 1),
                       rotor    = plane_surface(radii, {-0.4 * h, 0.2 * h, 0.6 * h}, 1);
  const MortarCoupling coupling = couple(tooth, rotor, 10. * h);
  ASSERT_EQ(coupling.nodes.size(), 4u);
  expect_sums_of_one(coupling);
  const auto function = [&](const double r, const double theta)
  { return 2. + 1e3 * (r - 0.03) - theta / h; };
  const Lines values = seen(coupling, rotor, 10. * h, 0., function);
  double area        = 0.;
  for (unsigned int i = 0; i < 4; ++i)
  {
    EXPECT_LT(coupling.nodes[i].tooth_node % 3, 2u);
    const Point<2> &place = tooth.nodes[coupling.nodes[i].tooth_node].place;
    EXPECT_NEAR(values[i], function(place[0], place[1]), 1e-12);
    area += coupling.nodes[i].area;
  }
  EXPECT_NEAR(area / (0.5 * 0.6 * h * (0.031 * 0.031 - 0.03 * 0.03)), 1., 1e-12);
}

TEST(Mortar, RefusesQuadraticFacesOfWhichTooLittleIsCovered)
{
  // The integral of (1 - s) (1 - 2 s) from 0.3 to 1 is negative.
  const double h = 0.01;
  EXPECT_THROW(couple(plane_surface({0.03, 0.031}, {0., h}, 2),
                      plane_surface({0.03, 0.031}, {0.3 * h, 2. * h}, 2), 10. * h),
               UserError);
}

TEST(Mortar, TakesTrapezoids)
{
  // Between slots of parallel walls the angles of a tooth's faces change with the radius.
  const double pitch   = 0.07;
  ContactSurface tooth = plane_surface({0.03, 0.0305, 0.032}, {-1., -0.3, 1.}, 1);
  const auto bend      = [](Point<2> &place) { place[1] *= 0.03 - std::asin(0.3e-3 / place[0]); };
  for (SurfaceNode &node : tooth.nodes)
    bend(node.place);
  for (auto &corners : tooth.corners)
    std::for_each(corners.begin(), corners.end(), bend);
  const ContactSurface rotor =
      plane_surface({0.0295, 0.0304, 0.0306, 0.0325}, {-0.5 * pitch, -0.01, 0.012, 0.5 * pitch}, 2);
  const MortarCoupling coupling = couple(tooth, rotor, pitch, 0.2 * pitch);
  ASSERT_EQ(coupling.nodes.size(), tooth.nodes.size());
  expect_sums_of_one(coupling);
  const auto function = [&](const double r, const double theta)
  { return 2. + 1e3 * (r - 0.03) - theta / pitch; };
  const Lines values = seen(coupling, rotor, pitch, 0.2 * pitch, function);
  double area = 0., expected = 0.;
  for (unsigned int i = 0; i < values.size(); ++i)
  {
    const Point<2> &place = tooth.nodes[coupling.nodes[i].tooth_node].place;
    EXPECT_NEAR(values[i], function(place[0], place[1]), 1e-12);
    area += coupling.nodes[i].area;
  }
  // Straight sides from (r_0, t_0) to (r_1, t_1): integral of 2 theta(r) r dr
  const Lines radii{0.03, 0.0305, 0.032};
  for (unsigned int i = 0; i < 2; ++i)
  {
    const auto half  = [&](const double r) { return 0.03 - std::asin(0.3e-3 / r); };
    const double r_0 = radii[i], r_1 = radii[i + 1];
    expected += integral(
        [&](const double r)
        { return 2. * r * (half(r_0) + (r - r_0) / (r_1 - r_0) * (half(r_1) - half(r_0))); },
        r_0, r_1);
  }
  EXPECT_NEAR(area / expected, 1., 1e-12);
}
