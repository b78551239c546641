// SPDX-License-Identifier: LGPL-2.1-or-later

// Piezoelectric cells. Expected values: the constitutive law solved by hand for a cube in a uniform
// state; the thickness modes of a laterally clamped plate, whose open-circuit frequencies are
// sqrt(c33D/rho)/(2t) and whose short-circuit ones solve k_t^2 tan(x)/x = 1; the exact quadratic
// solution of a strip in bending (Parton, Fracture mechanics of piezoelectric materials, 1976);
// frequencies of a free cube by a Ritz method with other functions, converged to the digits given.

#include "support/piezoelectric_box.h"

#include <ringmotor/elements/solid.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  /** A law of symmetry 4mm with c66 of its own. */
  PiezoelectricLaw law(const std::array<double, 6> &c, const std::array<double, 3> &e,
                       const double eps11, const double eps33)
  {
    PiezoelectricLaw law{};
    law.stiffness[0][0] = law.stiffness[1][1] = c[0];
    law.stiffness[0][1] = law.stiffness[1][0] = c[1];
    for (const unsigned int i : {0, 1})
      law.stiffness[i][2] = law.stiffness[2][i] = c[2];
    law.stiffness[2][2] = c[3];
    law.stiffness[3][3] = law.stiffness[4][4] = c[4];
    law.stiffness[5][5]                       = c[5];
    law.coupling[2][0] = law.coupling[2][1] = e[0];
    law.coupling[2][2]                      = e[1];
    law.coupling[0][4] = law.coupling[1][3] = e[2];
    law.permittivity[0][0] = law.permittivity[1][1] = eps11;
    law.permittivity[2][2]                          = eps33;
    return law;
  }

  Material ceramic(const PiezoelectricLaw &law, const double density)
  {
    Material material{};
    material.density = density;
    material.law     = law;
    return material;
  }

  // PZT-4 after different sources
  const PiezoelectricLaw of_cube = law({{137.6e9, 76.27e9, 73.13e9, 114.5e9, 25.64e9, 30.58e9}},
                                       {{-5.1714, 15.1005, 12.7174}}, 7e-9, 6e-9);
  const PiezoelectricLaw set_v =
      law({{132e9, 71e9, 73e9, 115e9, 26e9, 30e9}}, {{-4.1, 14.1, 10.5}}, 7.124e-9, 5.841e-9);

  bool is_zero(const double x)
  {
    return std::abs(x) < 1e-12;
  }

} // namespace

// Free of stress in a field along the poling axis, then under a stress along it, and with the field
// and that strain given: printed values of the cube in benchmark collections.
TEST(Piezoelectric, UniformCube)
{
  Box cube({1, 1, 1}, Point<3>(1., 1., 1.), 2, ceramic(of_cube, 7500.));
  const auto on_faces = [](const double z) { return is_zero(z) || is_zero(z - 1.); };
  const auto field    = [](const unsigned int c, const Point<3> &x)
  { return c == 3 ? -1e6 * x[2] : 0.; };
  cube.constrain([&](const unsigned int c, const Point<3> &x)
                 { return c < 3 ? is_zero(x[c]) : on_faces(x[2]); });
  const Point<3> corner(1., 1., 1.);
  Vector<double> loads(cube.component.size());
  Vector<double> state = cube.solve(loads, field);
  EXPECT_NEAR(cube.at(state, 0, corner), -1.23e-4, 0.005e-4);
  EXPECT_NEAR(cube.at(state, 1, corner), -1.23e-4, 0.005e-4);
  EXPECT_NEAR(cube.at(state, 2, corner), 2.89e-4, 0.005e-4);

  state = cube.solve(cube.face_loads(5, 2, [](const Point<3> &) { return 10e6; }), field);
  EXPECT_NEAR(cube.at(state, 0, corner), -1.7602e-4, 0.00005e-4);
  EXPECT_NEAR(cube.at(state, 1, corner), -1.7602e-4, 0.00005e-4);
  EXPECT_NEAR(cube.at(state, 2, corner), 4.4407e-4, 0.00005e-4);

  // Held sideways: stresses are reactions over the area of a face.
  cube.constrain([&](const unsigned int c, const Point<3> &x)
                 { return c < 3 ? is_zero(x[c]) || is_zero(x[c] - 1.) : on_faces(x[2]); });
  state                          = cube.solve(loads, [&](const unsigned int c, const Point<3> &x)
                                              { return c == 2 ? 1e-4 * x[2] : field(c, x); });
  const Vector<double> reactions = cube.reactions(state);
  std::array<double, 4> on_face{};
  for (unsigned int i = 0; i < reactions.size(); ++i)
    if (const unsigned int c = cube.component[i]; is_zero(cube.position[i][std::min(c, 2u)] - 1.))
      on_face[c] += reactions[i];
  EXPECT_NEAR(on_face[0], 12.4844e6, 50.);
  EXPECT_NEAR(on_face[1], 12.4844e6, 50.);
  EXPECT_NEAR(on_face[2], -3.6505e6, 50.);
  // The charge on the upper electrode is minus the flux D = e S + eps E.
  EXPECT_NEAR(on_face[3], 15.1005e-4 + 6e-9 * 1e6, 1e-12);
}

// Of a thin ring of 0.1 to 0.6 m and 20 mm between its electrodes: free, and held sideways but free
// across; from a cube of one cell, as its fields are uniform.
TEST(Piezoelectric, CapacitancesOfAThinRing)
{
  Box cube({1, 1, 1}, Point<3>(1., 1., 1.), 1, ceramic(set_v, 7500.));
  const double area_over_thickness = dealii::numbers::PI * (0.6 * 0.6 - 0.1 * 0.1) / 0.02;
  for (const bool is_held : {false, true})
  {
    cube.constrain(
        [&](const unsigned int c, const Point<3> &x) {
          return c == 3 ? is_zero(x[2]) || is_zero(x[2] - 1.) : is_zero(x[c]) || (is_held && c < 2);
        });
    const Vector<double> state =
        cube.solve(Vector<double>(cube.component.size()),
                   [](const unsigned int c, const Point<3> &x) { return c == 3 ? x[2] : 0.; });
    const Vector<double> reactions = cube.reactions(state);
    double charge                  = 0.;
    for (unsigned int i = 0; i < reactions.size(); ++i)
      if (cube.component[i] == 3 && is_zero(cube.position[i][2] - 1.))
        charge -= reactions[i];
    const double expected = is_held ? 4.1617054e-7 : 5.8591936e-7;
    EXPECT_NEAR(charge * area_over_thickness, expected, 1e-7 * expected);
  }
}

TEST(Piezoelectric, ThicknessModes)
{
  // The lowest frequencies with both faces at one potential and with the upper one insulated.
  const auto check = [](const PiezoelectricLaw &law, const double density,
                        const double short_circuit, const double open)
  {
    Box plate({1, 1, 3}, Point<3>(1e-3, 1e-3, 1e-3), 5, ceramic(law, density));
    const auto in_layers = [](const unsigned int c, const Point<3> &x) {
      return std::vector<long>{static_cast<long>(c), std::lround(1e9 * x[2])};
    };
    plate.constrain([](const unsigned int c, const Point<3> &x)
                    { return c < 2 || (c == 3 && (is_zero(x[2]) || is_zero(x[2] - 1e-3))); },
                    in_layers);
    EXPECT_NEAR(plate.frequencies(2)[1] * 1e-3, short_circuit, 1e-6 * short_circuit);
    plate.constrain([](const unsigned int c, const Point<3> &x)
                    { return c < 2 || (c == 3 && is_zero(x[2])); },
                    in_layers);
    EXPECT_NEAR(plate.frequencies(2)[1] * 1e-3, open, 1e-6 * open);
  };
  check(set_v, 7500., 2001.0679, 2228.8792);

  // PZT-5A, by its stiffened modulus and k_t, which are those of a table
  const double stiffened = 110e9 + 15.8 * 15.8 / 7.3e-9, k_t = 15.8 / std::sqrt(7.3e-9 * stiffened),
               open = 0.5 * std::sqrt(stiffened / 7750.);
  EXPECT_NEAR(stiffened, 144.197e9, 0.5e6);
  EXPECT_NEAR(k_t, 0.486987, 5e-7);
  double low = 0.5 * open, high = open;
  while (high - low > 1e-9 * open)
  {
    const double middle = 0.5 * (low + high), x = 0.5 * dealii::numbers::PI * middle / open;
    (k_t * k_t * std::tan(x) < x ? low : high) = middle;
  }
  check(law({{120e9, 75.2e9, 75.1e9, 110e9, 21.1e9, 22.4e9}}, {{-5.4, 15.8, 12.3}}, 8.1e-9, 7.3e-9),
        7750., low, open);
}

// Stress sigma_x = -20 z N/mm^3 along a strip between open electrodes; a solid that is free
// sideways is in plane stress. In plane strain the field would be -163.37 V/mm.
TEST(Piezoelectric, BendingStrip)
{
  constexpr double length = 1e-3, height = 0.5e-3, slope = -20e9, eps0 = 8.854e-12;
  Box strip({2, 1, 2}, Point<3>(length, 0.2e-3, height), 2,
            ceramic(law({{139e9, 77.8e9, 74.3e9, 115e9, 25.6e9, 30.6e9}}, {{-5.2, 15.1, 12.7}},
                        728.5 * eps0, 634.7 * eps0),
                    7500.));
  // The upper half; z = 0 is the middle of the strip, of which both halves are the same but for
  // signs.
  strip.constrain(
      [](const unsigned int c, const Point<3> &x) {
        return c == 3 ? is_zero(x[2]) : c == 2 ? is_zero(x.norm()) : is_zero(x[c]) || is_zero(x[2]);
      });
  const Vector<double> state =
      strip.solve(strip.face_loads(1, 0, [](const Point<3> &x) { return slope * x[2]; }),
                  [](const unsigned int, const Point<3> &) { return 0.; });
  const double quarter = strip.at(state, 3, Point<3>(0., 0., 0.5 * height)),
               top     = strip.at(state, 3, Point<3>(0., 0., height));
  EXPECT_NEAR((4. * quarter - 3. * top) / height, -109.5146e3, 0.05);
  EXPECT_NEAR(strip.at(state, 0, Point<3>(length, 0., height)), -0.109533e-6, 0.5e-12);
  EXPECT_NEAR(strip.at(state, 2, Point<3>(length, 0., height)), 0.11493e-6, 5e-12);
}

// An eighth of a cube between two electrodes. Modes that are odd under exchange of x and y have no
// charge and are not in the table.
TEST(Piezoelectric, FreeCube)
{
  constexpr double half = 0.01;
  Box octant({1, 1, 1}, Point<3>(half, half, half), 6, ceramic(set_v, 7500.));
  const auto expect_among =
      [](const std::vector<double> &found, const std::vector<double> &expected)
  {
    for (const double f : expected)
    {
      double nearest = 0.;
      for (const double other : found)
        if (std::abs(other - f) < std::abs(nearest - f))
          nearest = other;
      EXPECT_NEAR(nearest, f, 2e-5 * f);
    }
  };
  octant.constrain([](const unsigned int c, const Point<3> &x)
                   { return c < 3 ? is_zero(x[c]) : is_zero(x[2]) || is_zero(x[2] - half); });
  expect_among(octant.frequencies(12), {65.1012e3, 88.1365e3, 122.2458e3, 134.0982e3});
  octant.constrain(
      [](const unsigned int c, const Point<3> &x) { return c < 3 ? is_zero(x[c]) : is_zero(x[2]); },
      [](const unsigned int c, const Point<3> &x)
      { return c == 3 && is_zero(x[2] - half) ? std::vector<long>{1} : std::vector<long>(); });
  expect_among(octant.frequencies(12), {79.8067e3, 93.5772e3, 122.8395e3, 134.3893e3});
}

// Energies at quadrature points are those of the matrices.
TEST(Piezoelectric, ProductsAreThoseOfMatrices)
{
  dealii::Triangulation<3> triangulation;
  dealii::GridGenerator::hyper_cube(triangulation, 0., 2e-3);
  const dealii::MappingQ<3> mapping(1);
  const dealii::FESystem<3> fe(dealii::FE_Q<3>(3), 3);
  SolidElement element(mapping, fe);
  element.reinit(triangulation.begin_active(), ceramic(set_v, 7500.));
  const unsigned int n_u = fe.n_dofs_per_cell(), n_phi = n_u / 3;
  FullMatrix<double> k(n_u, n_u), b(n_u, n_phi), d(n_phi, n_phi);
  element.piezoelectric_matrices(k, b, d);
  Vector<double> u(n_u), phi(n_phi), times(n_u);
  for (unsigned int i = 0; i < n_u; ++i)
    u[i] = std::sin(1. + i * i);
  for (unsigned int i = 0; i < n_phi; ++i)
    phi[i] = std::cos(3. * i * i);
  const ElectricProducts products = element.electric_products({u}, {phi}).front();
  k.vmult(times, u);
  EXPECT_NEAR(element.stiffness_products({u}).front(), u * times, 1e-11 * std::abs(u * times));
  b.vmult(times, phi);
  EXPECT_NEAR(products.coupling, u * times, 1e-11 * times.l2_norm() * u.l2_norm());
  EXPECT_NEAR(products.dielectric, d.matrix_norm_square(phi), 1e-11 * products.dielectric);
}
