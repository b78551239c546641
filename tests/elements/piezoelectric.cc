// SPDX-License-Identifier: LGPL-2.1-or-later

// Piezoelectric cells. Expected values: the constitutive law solved by hand for a cube in a uniform
// state; the thickness modes of a laterally clamped plate, whose open-circuit frequencies are
// sqrt(c33D/rho)/(2t) and whose short-circuit ones solve k_t^2 tan(x)/x = 1; the exact quadratic
// solution of a strip in bending (Parton, Fracture mechanics of piezoelectric materials, 1976);
// frequencies of a free cube by a Ritz method with other functions, converged to the digits given.

#include <ringmotor/elements/solid.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <vector>

using namespace ringmotor;
using dealii::FullMatrix;
using dealii::Point;
using dealii::Vector;

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

  /**
   * A box of cells between the origin and a corner as dense matrices. Each degree of freedom,
   * component 0 to 2 of displacement or 3 for the potential, is fixed or follows an unknown, chosen
   * by component and position.
   */
  class Box
  {
  public:
    Box(const std::vector<unsigned int> &n_cells, const Point<3> &corner, const unsigned int degree,
        const Material &material)
        : mapping(1), scalar(degree), fe(scalar, 3), solid(triangulation), potential(triangulation)
    {
      dealii::GridGenerator::subdivided_hyper_rectangle(triangulation, n_cells, Point<3>(), corner,
                                                        true);
      solid.distribute_dofs(fe);
      potential.distribute_dofs(scalar);
      const unsigned int n = solid.n_dofs(), n_total = n + potential.n_dofs();
      matrix.reinit(n_total, n_total);
      mass.reinit(n_total, n_total);
      component.resize(n_total, 3);
      position.resize(n_total);
      SolidElement element(mapping, fe);
      const unsigned int n_u = fe.n_dofs_per_cell(), n_phi = scalar.n_dofs_per_cell();
      FullMatrix<double> k(n_u, n_u), b(n_u, n_phi), d(n_phi, n_phi), m(n_u, n_u);
      std::vector<dealii::types::global_dof_index> u_dofs(n_u), phi_dofs(n_phi);
      auto other = potential.begin_active();
      for (const auto &cell : solid.active_cell_iterators())
      {
        element.reinit(cell, material);
        element.piezoelectric_matrices(k, b, d);
        element.mass_matrix(m);
        cell->get_dof_indices(u_dofs);
        (other++)->get_dof_indices(phi_dofs);
        for (unsigned int i = 0; i < n_u; ++i)
        {
          const auto [c, node] = fe.system_to_component_index(i);
          component[u_dofs[i]] = c;
          position[u_dofs[i]]  = position[n + phi_dofs[node]] =
              mapping.transform_unit_to_real_cell(cell, scalar.unit_support_point(node));
          for (unsigned int j = 0; j < n_u; ++j)
          {
            matrix(u_dofs[i], u_dofs[j]) += k(i, j);
            mass(u_dofs[i], u_dofs[j]) += m(i, j);
          }
          for (unsigned int j = 0; j < n_phi; ++j)
          {
            matrix(u_dofs[i], n + phi_dofs[j]) += b(i, j);
            matrix(n + phi_dofs[j], u_dofs[i]) += b(i, j);
          }
        }
        for (unsigned int i = 0; i < n_phi; ++i)
          for (unsigned int j = 0; j < n_phi; ++j)
            matrix(n + phi_dofs[i], n + phi_dofs[j]) -= d(i, j);
      }
    }

    /** Fixes some degrees of freedom; those with equal keys share an unknown. */
    void constrain(const std::function<bool(unsigned int, const Point<3> &)> &is_fixed,
                   const std::function<std::vector<long>(unsigned int, const Point<3> &)> &key = {})
    {
      std::map<std::vector<long>, int> known;
      unknown.assign(component.size(), -1);
      is_potential.clear();
      for (unsigned int i = 0; i < component.size(); ++i)
        if (!is_fixed(component[i], position[i]))
        {
          std::vector<long> name = key ? key(component[i], position[i]) : std::vector<long>();
          if (name.empty())
            name = {-1, i};
          const auto [found, is_new] = known.emplace(name, is_potential.size());
          if (is_new)
            is_potential.push_back(component[i] == 3);
          unknown[i] = found->second;
        }
    }

    /** The lowest frequencies in Hz, with the potential eliminated. */
    std::vector<double> frequencies(const unsigned int n_wanted) const
    {
      const FullMatrix<double> k = reduced(matrix), m = reduced(mass);
      const std::vector<unsigned int> mechanical = places(false), electrical = places(true);
      FullMatrix<double> stiffness(mechanical.size(), mechanical.size()),
          inertia(mechanical.size(), mechanical.size()),
          across(electrical.size(), mechanical.size()), response(across),
          dielectric(electrical.size(), electrical.size()), inverse(dielectric);
      stiffness.extract_submatrix_from(k, mechanical, mechanical);
      inertia.extract_submatrix_from(m, mechanical, mechanical);
      if (!electrical.empty())
      {
        across.extract_submatrix_from(k, electrical, mechanical);
        dielectric.extract_submatrix_from(k, electrical, electrical);
        inverse.invert(dielectric);
        inverse.mmult(response, across);
        FullMatrix<double> stiffening(stiffness);
        across.Tmmult(stiffening, response);
        stiffness.add(-1., stiffening);
      }
      dealii::LAPACKFullMatrix<double> a(mechanical.size()), b(mechanical.size());
      a = stiffness;
      b = inertia;
      std::vector<Vector<double>> modes(n_wanted, Vector<double>(mechanical.size()));
      a.compute_generalized_eigenvalues_symmetric(b, modes);
      std::vector<double> found;
      for (unsigned int i = 0; i < n_wanted; ++i)
        found.push_back(std::sqrt(std::max(0., a.eigenvalue(i).real())) /
                        (2. * dealii::numbers::PI));
      return found;
    }

    /** All degrees of freedom under loads, with values given where they are fixed. */
    Vector<double> solve(const Vector<double> &loads,
                         const std::function<double(unsigned int, const Point<3> &)> &given) const
    {
      Vector<double> fixed(component.size()), rest(component.size());
      for (unsigned int i = 0; i < component.size(); ++i)
        if (unknown[i] < 0)
          fixed[i] = given(component[i], position[i]);
      matrix.vmult(rest, fixed);
      Vector<double> sides(is_potential.size());
      for (unsigned int i = 0; i < component.size(); ++i)
        if (unknown[i] >= 0)
          sides[unknown[i]] += loads[i] - rest[i];
      dealii::LAPACKFullMatrix<double> factors(is_potential.size());
      factors = reduced(matrix);
      factors.compute_lu_factorization();
      factors.solve(sides);
      for (unsigned int i = 0; i < component.size(); ++i)
        if (unknown[i] >= 0)
          fixed[i] = sides[unknown[i]];
      return fixed;
    }

    /** Loads of a traction or a charge per area on the faces with a boundary id. */
    Vector<double> face_loads(const dealii::types::boundary_id face_id, const unsigned int of,
                              const std::function<double(const Point<3> &)> &density) const
    {
      Vector<double> loads(component.size());
      dealii::FEFaceValues<3> values(mapping, scalar, dealii::QGauss<2>(scalar.degree + 2),
                                     dealii::update_values | dealii::update_JxW_values |
                                         dealii::update_quadrature_points);
      std::vector<dealii::types::global_dof_index> dofs(scalar.n_dofs_per_cell()),
          u_dofs(fe.n_dofs_per_cell());
      auto other = solid.begin_active();
      for (const auto &cell : potential.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        (other++)->get_dof_indices(u_dofs);
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face) && cell->face(face)->boundary_id() == face_id)
          {
            values.reinit(cell, face);
            for (const unsigned int q : values.quadrature_point_indices())
              for (unsigned int i = 0; i < dofs.size(); ++i)
                loads[of == 3 ? solid.n_dofs() + dofs[i]
                              : u_dofs[fe.component_to_system_index(of, i)]] +=
                    values.JxW(q) * values.shape_value(i, q) * density(values.quadrature_point(q));
          }
      }
      return loads;
    }

    /** The value of a component at a node. */
    double at(const Vector<double> &solution, const unsigned int of, const Point<3> &where) const
    {
      for (unsigned int i = 0; i < component.size(); ++i)
        if (component[i] == of && position[i].distance(where) < 1e-6 * where.norm() + 1e-12)
          return solution[i];
      ADD_FAILURE() << "no node at " << where;
      return 0.;
    }

    /** Forces and minus charges that keep a solution. */
    Vector<double> reactions(const Vector<double> &solution) const
    {
      Vector<double> result(solution.size());
      matrix.vmult(result, solution);
      return result;
    }

    std::vector<unsigned int> component; ///< by degree of freedom; 3 for the potential
    std::vector<Point<3>> position;

  private:
    FullMatrix<double> reduced(const FullMatrix<double> &whole) const
    {
      FullMatrix<double> result(is_potential.size(), is_potential.size());
      for (unsigned int i = 0; i < component.size(); ++i)
        for (unsigned int j = 0; j < component.size(); ++j)
          if (unknown[i] >= 0 && unknown[j] >= 0)
            result(unknown[i], unknown[j]) += whole(i, j);
      return result;
    }

    std::vector<unsigned int> places(const bool of_potential) const
    {
      std::vector<unsigned int> places;
      for (unsigned int i = 0; i < is_potential.size(); ++i)
        if (is_potential[i] == of_potential)
          places.push_back(i);
      return places;
    }

    dealii::Triangulation<3> triangulation;
    dealii::MappingQ<3> mapping;
    dealii::FE_Q<3> scalar;
    dealii::FESystem<3> fe;
    dealii::DoFHandler<3> solid, potential;
    FullMatrix<double> matrix, mass;
    std::vector<int> unknown;
    std::vector<bool> is_potential;
  };

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
