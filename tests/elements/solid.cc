// SPDX-License-Identifier: LGPL-2.1-or-later

// Cell matrices of the solid element against properties of any correct one: no energy in rigid
// motions, exact energy of a uniform strain (1/2 strain : stress : strain times the volume, by
// Hooke's law), mass and inertia of the body, also on distorted cells with curved sides. The patch
// test: neighbouring distorted cells in a uniform strain exert no net force on inner nodes.

#include "support/geometry.h"
#include "support/materials.h"

#include <ringmotor/elements/solid.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const Material material{70.e9, 0.33, 2700., 0.};

  using Displacement = std::function<Tensor<1, 3>(const Point<3> &)>;

  /** 2 x 2 x 2 distorted cells; inner faces and sides are curved around the z axis. With a height
   * of 1 the cells are about as high as wide. */
  class Patch
  {
  public:
    explicit Patch(const unsigned int degree, const double height = 1.)
        : mapping(2), fe(dealii::FE_Q<3>(degree), 3), dof_handler(triangulation)
    {
      dealii::GridGenerator::subdivided_hyper_rectangle(triangulation, {2, 2, 2},
                                                        Point<3>(1., 0., 0.), Point<3>(2., 1., 1.));
      dealii::GridTools::transform(
          [height](const Point<3> &x)
          {
            return Point<3>(x[0] + 0.1 * x[1] * x[2], x[1] + 0.13 * x[0] * x[2] * x[2],
                            height * (x[2] - 0.08 * x[0] + 0.11 * x[1] * x[0]));
          },
          triangulation);
      triangulation.set_all_manifold_ids(0);
      triangulation.set_manifold(0, dealii::CylindricalManifold<3>(2));
      dof_handler.distribute_dofs(fe);
    }

    double volume() const { return volumes(triangulation, 2).begin()->second; }

    dealii::Vector<double> interpolate(const Displacement &displacement) const
    {
      std::vector<Point<3>> positions(dof_handler.n_dofs());
      dealii::DoFTools::map_dofs_to_support_points(mapping, dof_handler, positions);
      dealii::Vector<double> field(dof_handler.n_dofs());
      for_each_cell(
          [&](const auto &dofs, const auto &, const auto &)
          {
            for (unsigned int i = 0; i < dofs.size(); ++i)
              field[dofs[i]] =
                  displacement(positions[dofs[i]])[fe.system_to_component_index(i).first];
          });
      return field;
    }

    /** Forces that maintain this displacement field. */
    dealii::Vector<double> forces(const dealii::Vector<double> &field) const
    {
      dealii::Vector<double> sum(dof_handler.n_dofs());
      for_each_cell(
          [&](const auto &dofs, const auto &stiffness, const auto &)
          {
            for (unsigned int i = 0; i < dofs.size(); ++i)
              for (unsigned int j = 0; j < dofs.size(); ++j)
                sum[dofs[i]] += stiffness(i, j) * field[dofs[j]];
          });
      return sum;
    }

    /** Twice the strain energy. */
    double stiffness_product(const dealii::Vector<double> &field) const
    {
      return forces(field) * field;
    }

    double mass_product(const dealii::Vector<double> &a, const dealii::Vector<double> &b) const
    {
      double sum = 0.;
      for_each_cell(
          [&](const auto &dofs, const auto &, const auto &mass)
          {
            for (unsigned int i = 0; i < dofs.size(); ++i)
              for (unsigned int j = 0; j < dofs.size(); ++j)
                sum += a[dofs[i]] * mass(i, j) * b[dofs[j]];
          });
      return sum;
    }

    /** Without matrices: u.K u and u.M u of fields. */
    std::vector<double> stiffness_products(const std::vector<dealii::Vector<double>> &fields) const
    {
      return products(fields, &SolidElement::stiffness_products);
    }
    std::vector<double> mass_products(const std::vector<dealii::Vector<double>> &fields) const
    {
      return products(fields, &SolidElement::mass_products);
    }

    /** Calls use(dofs, stiffness, mass) for each cell. */
    template <typename Use>
    void for_each_cell(const Use &use) const
    {
      SolidElement element(mapping, fe);
      const unsigned int size = fe.n_dofs_per_cell();
      dealii::FullMatrix<double> stiffness(size, size), mass(size, size);
      std::vector<dealii::types::global_dof_index> dofs(size);
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        element.reinit(cell, material);
        element.matrices(stiffness, mass);
        cell->get_dof_indices(dofs);
        use(dofs, stiffness, mass);
      }
    }

    std::vector<bool> on_boundary() const
    {
      const dealii::IndexSet set = dealii::DoFTools::extract_boundary_dofs(dof_handler);
      std::vector<bool> flags(dof_handler.n_dofs());
      for (const auto dof : set)
        flags[dof] = true;
      return flags;
    }

  private:
    template <typename Product>
    std::vector<double> products(const std::vector<dealii::Vector<double>> &fields,
                                 const Product product) const
    {
      SolidElement element(mapping, fe);
      std::vector<dealii::Vector<double>> local(fields.size(),
                                                dealii::Vector<double>(fe.n_dofs_per_cell()));
      std::vector<double> sums(fields.size(), 0.);
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        element.reinit(cell, material);
        for (unsigned int i = 0; i < fields.size(); ++i)
          cell->get_dof_values(fields[i], local[i]);
        const std::vector<double> of_cell = (element.*product)(local);
        for (unsigned int i = 0; i < fields.size(); ++i)
          sums[i] += of_cell[i];
      }
      return sums;
    }

    dealii::Triangulation<3> triangulation;
    const dealii::MappingQ<3> mapping;
    const dealii::FESystem<3> fe;
    dealii::DoFHandler<3> dof_handler;
  };

  Tensor<1, 3> vector(const double x, const double y, const double z)
  {
    Tensor<1, 3> v;
    v[0] = x;
    v[1] = y;
    v[2] = z;
    return v;
  }

  Displacement linear(const dealii::Tensor<2, 3> &gradient)
  {
    return [gradient](const Point<3> &x) { return gradient * Tensor<1, 3>(x); };
  }

  dealii::Tensor<2, 3> generic_gradient()
  {
    dealii::Tensor<2, 3> gradient;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        gradient[i][j] = 1e-3 * std::sin(1. + 3. * i + 2. * j);
    return gradient;
  }

  /** Hooke's law, in terms of E and nu: strain : stress. */
  double exact_energy_density(const dealii::Tensor<2, 3> &gradient)
  {
    const dealii::Tensor<2, 3> strain = 0.5 * (gradient + dealii::transpose(gradient));
    const double nu                   = material.poisson_ratio;
    return material.young_modulus / (1. + nu) *
           (strain.norm_square() +
            nu / (1. - 2. * nu) * dealii::trace(strain) * dealii::trace(strain));
  }

  void expect_no_inner_forces(const Patch &patch, const unsigned int degree, const double tolerance)
  {
    const auto forces           = patch.forces(patch.interpolate(linear(generic_gradient())));
    const std::vector<bool> out = patch.on_boundary();
    double largest              = 0.;
    unsigned int n_inner        = 0;
    for (unsigned int dof = 0; dof < forces.size(); ++dof)
      largest = std::max(largest, std::abs(forces[dof]));
    for (unsigned int dof = 0; dof < forces.size(); ++dof)
      if (!out[dof])
      {
        EXPECT_NEAR(forces[dof] / largest, 0., tolerance);
        ++n_inner;
      }
    EXPECT_EQ(n_inner, 3 * std::pow(2 * degree - 1, 3));
  }

  /** The geometry is of second degree in each direction: only such elements represent it exactly.
   */
  class Solid : public testing::TestWithParam<unsigned int>
  {
  };
  using SolidHard = Solid;
} // namespace

TEST_P(Solid, RigidMotionsCostNothing)
{
  const Patch patch(GetParam());
  const double stretch = patch.stiffness_product(
      patch.interpolate([](const auto &x) { return vector(x[0], 0., 0.); }));
  for (const Displacement &rigid :
       {Displacement([](const auto &) { return vector(1., 0., 0.); }),
        Displacement([](const auto &) { return vector(0., 1., 0.); }),
        Displacement([](const auto &) { return vector(0., 0., 1.); }),
        Displacement([](const auto &x) { return vector(0., -x[2], x[1]); }),
        Displacement([](const auto &x) { return vector(x[2], 0., -x[0]); }),
        Displacement([](const auto &x) { return vector(-x[1], x[0], 0.); })})
    EXPECT_NEAR(patch.stiffness_product(patch.interpolate(rigid)) / stretch, 0., 1e-13);
}

TEST_P(Solid, UniformStrainHasTheExactEnergy)
{
  const Patch patch(GetParam());
  const double exact = patch.volume() * exact_energy_density(generic_gradient());
  const auto field   = patch.interpolate(linear(generic_gradient()));
  EXPECT_NEAR(patch.stiffness_product(field) / exact, 1., 1e-12);
}

TEST_P(Solid, PassesThePatchTest)
{
  expect_no_inner_forces(Patch(GetParam()), GetParam(), 1e-12);
}

TEST_P(SolidHard, ThinCellsPassThePatchTest)
{
  // Cells 100 times as wide as high: the matrix loses two digits, the matrix-free energies none.
  const Patch patch(GetParam(), 0.01);
  const double exact = patch.volume() * exact_energy_density(generic_gradient());
  const auto field   = patch.interpolate(linear(generic_gradient()));
  EXPECT_NEAR(patch.stiffness_product(field) / exact, 1., 2e-10);
  EXPECT_NEAR(patch.stiffness_products({field})[0] / exact, 1., 1e-12);
  expect_no_inner_forces(patch, GetParam(), 1e-10);
}

TEST_P(Solid, MassAndInertiaAreThoseOfTheBody)
{
  const Patch patch(GetParam());
  const double exact = material.density * patch.volume();
  std::vector<dealii::Vector<double>> shifts;
  for (unsigned int d = 0; d < 3; ++d)
    shifts.push_back(patch.interpolate(
        [d](const auto &)
        {
          Tensor<1, 3> v;
          v[d] = 1.;
          return v;
        }));
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      EXPECT_NEAR(patch.mass_product(shifts[i], shifts[j]) / exact, i == j ? 1. : 0., 1e-12);
  // x times x: twice the energy of a stretch is the second moment in either direction
  const auto stretch = patch.interpolate([](const auto &x) { return vector(0., 0., x[0]); });
  const auto other   = patch.interpolate([](const auto &x) { return vector(x[0], 0., 0.); });
  EXPECT_NEAR(patch.mass_product(stretch, stretch) / patch.mass_product(other, other), 1., 1e-12);
  EXPECT_NEAR(patch.mass_product(stretch, other) / exact, 0., 1e-12);
}

TEST_P(Solid, MatricesAreSymmetricAndFull)
{
  const Patch patch(GetParam());
  patch.for_each_cell(
      [&](const auto &dofs, const auto &stiffness, const auto &mass)
      {
        for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          EXPECT_GT(stiffness(i, i), 0.);
          EXPECT_GT(mass(i, i), 0.);
          for (unsigned int j = 0; j < i; ++j)
          {
            EXPECT_NEAR(stiffness(i, j), stiffness(j, i), 1e-12 * stiffness(i, i));
            EXPECT_NEAR(mass(i, j), mass(j, i), 1e-12 * mass(i, i));
          }
        }
      });
}

TEST_P(Solid, EnergiesOfMotionsNeedNoMatrices)
{
  // The exact energy of a uniform strain again, the inertia of a translation, and for a generic
  // motion the same as with the matrices.
  const Patch patch(GetParam());
  const auto stretch = patch.interpolate(linear(generic_gradient()));
  const auto shift   = patch.interpolate([](const auto &) { return vector(0.6, 0., 0.8); });
  const auto any     = patch.interpolate(
      [](const auto &x) { return vector(std::sin(3. * x[1]), x[0] * x[2], std::exp(x[0])); });
  const std::vector<double> stiffness = patch.stiffness_products({stretch, shift, any}),
                            mass      = patch.mass_products({stretch, shift, any});
  EXPECT_NEAR(stiffness[0] / (patch.volume() * exact_energy_density(generic_gradient())), 1.,
              1e-12);
  EXPECT_NEAR(stiffness[1] / stiffness[2], 0., 1e-24);
  EXPECT_NEAR(stiffness[2] / patch.stiffness_product(any), 1., 1e-12);
  EXPECT_NEAR(mass[0] / patch.mass_product(stretch, stretch), 1., 1e-12);
  EXPECT_NEAR(mass[1] / (material.density * patch.volume()), 1., 1e-12);
  EXPECT_NEAR(mass[2] / patch.mass_product(any, any), 1., 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Degrees, Solid, testing::Values(2, 3, 4));
INSTANTIATE_TEST_SUITE_P(Degrees, SolidHard, testing::Values(2, 3, 4));
