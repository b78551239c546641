// SPDX-License-Identifier: LGPL-2.1-or-later

// The shell element, degree 1 (MITC4) to 4: zero energy in rigid motions and in no other motion of
// a cell, exact energies of uniform stretch, transverse shear, bending and twist of a flat patch
// (classical plate theory, exact for these states), no net force on the inner nodes of such a patch
// (the patch test), mass and inertia of the body. Hard: the same on strongly distorted cells, on
// cells with an aspect ratio of 1:100 and for thin shells.

#include "support/shell_model.h"

#include <deal.II/lac/lapack_full_matrix.h>

#include <random>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  using Motion = std::function<Vector6(const Point<3> &)>;

  constexpr double young = 2e9, poisson = 0.3;
  const Material material{young, poisson, 1000., 0.};

  Shell patch(const unsigned int degree, const double thickness, const ParameterMesh &mesh)
  {
    return Shell(plane, mesh, degree, material, {thickness});
  }

  const ParameterMesh distorted{{0., 0.}, {2., 1.}, {{3, 3}}, 0.08};

  /** A uniform state of the plane. */
  struct UniformState
  {
    const char *name;
    Motion motion;
    double energy_density; ///< twice the energy in N/m
  };

  std::vector<UniformState> uniform_states(const double t)
  {
    const double membrane = young * t / (1. - poisson * poisson), bending = membrane * t * t / 12.,
                 shear = 5. / 6. * young / (2. * (1. + poisson)) * t;
    const double a = 1e-3, b = -4e-4, c = 6e-4;
    return {// u = (a x + c y, b y, 0); the rotation about the normal follows the turn -c/2.
            {"membrane",
             [=](const Point<3> &x) {
               return Vector6{{a * x[0] + c * x[1], b * x[1], 0., 0., 0., -0.5 * c}};
             },
             membrane * (a * a + b * b + 2. * poisson * a * b + 0.5 * (1. - poisson) * c * c)},
            // The normals stay upright. 5/6 of the section carries the shear.
            {"shear",
             [=](const Point<3> &x) {
               return Vector6{{0., 0., a * x[0] + b * x[1], 0., 0., 0.}};
             },
             shear * (a * a + b * b)},
            // w = -(a x^2 + b y^2)/2 - c x y; the normal turns by theta = (w_y, -w_x, 0).
            {"bending",
             [=](const Point<3> &x)
             {
               return Vector6{{0., 0., -0.5 * (a * x[0] * x[0] + b * x[1] * x[1]) - c * x[0] * x[1],
                               -b * x[1] - c * x[0], a * x[0] + c * x[1], 0.}};
             },
             bending * (a * a + b * b + 2. * poisson * a * b + 0.5 * (1. - poisson) * 4. * c * c)}};
  }

  void expect_exact_energies(const unsigned int degree, const double t, const ParameterMesh &mesh,
                             const double tolerance)
  {
    const Shell shell = patch(degree, t, mesh);
    const double area = (mesh.high[0] - mesh.low[0]) * (mesh.high[1] - mesh.low[1]);
    for (const UniformState &state : uniform_states(t))
      EXPECT_NEAR(shell.squares(shell.interpolate(state.motion)).first /
                      (area * state.energy_density),
                  1., tolerance)
          << state.name << ", t = " << t;
  }

  /** Inner nodes are in equilibrium in uniform states; not in moments if the normals stay upright
   * in shear. */
  void expect_no_inner_forces(const unsigned int degree, const double t, const ParameterMesh &mesh,
                              const double tolerance)
  {
    const Shell shell = patch(degree, t, mesh);
    const auto inner  = [&](const Point<3> &x)
    {
      return x[0] > mesh.low[0] + 1e-9 && x[0] < mesh.high[0] - 1e-9 && x[1] > mesh.low[1] + 1e-9 &&
             x[1] < mesh.high[1] - 1e-9;
    };
    for (const UniformState &state : uniform_states(t))
    {
      const auto forces                   = shell.forces(shell.interpolate(state.motion));
      std::array<double, 2> largest_inner = {{0., 0.}}, largest = {{0., 0.}};
      for (unsigned int dof = 0; dof < forces.size(); ++dof)
      {
        const unsigned int kind = shell.component(dof) / 3;
        largest[kind]           = std::max(largest[kind], std::abs(forces[dof]));
        if (inner(shell.position(dof)))
          largest_inner[kind] = std::max(largest_inner[kind], std::abs(forces[dof]));
      }
      const unsigned int kind = state.name == std::string("bending") ? 1 : 0;
      EXPECT_LT(largest_inner[kind] / largest[kind], tolerance) << state.name;
    }
  }

  class ShellDegrees : public testing::TestWithParam<unsigned int>
  {
  };
  using ShellDegreesHard = ShellDegrees;
} // namespace

TEST_P(ShellDegrees, RigidMotionsCostNothing)
{
  for (const double offset : {0., 0.02})
  {
    const Shell shell(cylinder(1.), {{0., 0.2}, {0.7, 1.3}, {{2, 2}}, 0.1}, GetParam(),
                      {1e9, 0.3, 1000., 0.}, {0.05, offset});
    const auto stretch = shell.interpolate(
        [](const Point<3> &x) {
          return Vector6{{x[0], 0., 0., 0., 0., 0.}};
        });
    const double scale = shell.squares(stretch).first;
    for (unsigned int d = 0; d < 3; ++d)
    {
      Tensor<1, 3> axis;
      axis[d]         = 1.;
      const auto turn = shell.interpolate(
          [&](const Point<3> &x)
          {
            const Tensor<1, 3> u = cross_product_3d(axis, Tensor<1, 3>(x));
            return Vector6{{u[0], u[1], u[2], axis[0], axis[1], axis[2]}};
          });
      const auto shift = shell.interpolate(
          [&](const Point<3> &) {
            return Vector6{{axis[0], axis[1], axis[2], 0., 0., 0.}};
          });
      EXPECT_NEAR(shell.products(turn, turn).first / scale, 0., 1e-12);
      EXPECT_NEAR(shell.products(shift, shift).first / scale, 0., 1e-12);
    }
  }
}

TEST_P(ShellDegrees, OnlyRigidMotionsAreFree)
{
  const Shell shell(cylinder(1.), {{0., 0.2}, {0.7, 1.3}, {{1, 1}}}, GetParam(), material, {0.1});
  shell.for_each_cell(
      [&](const auto &, const auto &stiffness, const auto &)
      {
        dealii::LAPACKFullMatrix<double> copy(stiffness.m(), stiffness.m());
        dealii::FullMatrix<double> vectors(stiffness.m(), stiffness.m());
        dealii::Vector<double> values(stiffness.m());
        copy = stiffness;
        copy.compute_eigenvalues_symmetric(-1e30, 1e30, 0., values, vectors);
        EXPECT_LT(std::abs(values[5]) / values[values.size() - 1], 1e-14);
        // The coupling of the rotation about the normal is that weak.
        EXPECT_GT(values[6] / values[values.size() - 1], 1e-11);
      });
}

TEST_P(ShellDegrees, UniformStatesHaveTheExactEnergy)
{
  expect_exact_energies(GetParam(), 0.1, distorted, 1e-11);
}

TEST_P(ShellDegrees, PassesThePatchTest)
{
  expect_no_inner_forces(GetParam(), 0.1, distorted, 1e-11);
}

TEST_P(ShellDegrees, MassAndInertiaAreThoseOfTheBody)
{
  const double rho = 1000., t = 0.1, offset = 0.03, area = 2.;
  const Shell shell(plane, {{0., 0.}, {2., 1.}, {{2, 2}}, 0.08}, GetParam(), {2e9, 0.3, rho, 0.},
                    {t, offset});
  const auto lift = shell.interpolate(
      [](const Point<3> &) {
        return Vector6{{0., 0., 1., 0., 0., 0.}};
      });
  const auto turn = shell.interpolate(
      [](const Point<3> &x) {
        return Vector6{{0., 0., x[1], 1., 0., 0.}};
      });
  EXPECT_NEAR(shell.products(lift, lift).second / (rho * t * area), 1., 1e-12);
  // About the x axis: y^2 + z^2 over the body
  const double inertia = rho * (2. * t / 3. + area * (t * t * t / 12. + t * offset * offset));
  EXPECT_NEAR(shell.products(turn, turn).second / inertia, 1., 1e-12);
}

TEST_P(ShellDegrees, EnergiesOfMotionsNeedNoMatrices)
{
  const Shell shell(cylinder(1.), {{0., 0.2}, {0.7, 1.3}, {{2, 2}}, 0.1}, GetParam(), material,
                    {0.05, 0.01});
  std::mt19937 random;
  dealii::Vector<double> any(shell.n_dofs());
  for (double &entry : any)
    entry = std::generate_canonical<double, 53>(random) - 0.5;
  const auto [stiffness, mass]                     = shell.squares(any);
  const auto [by_stiffness_matrix, by_mass_matrix] = shell.products(any, any);
  EXPECT_NEAR(stiffness / by_stiffness_matrix, 1., 1e-12);
  EXPECT_NEAR(mass / by_mass_matrix, 1., 1e-12);
}

TEST_P(ShellDegreesHard, ThinShellsTellRigidMotionsFromBending)
{
  // A shell of 1e-4 of its radius moves rigidly by a hundred times its radius. The remaining
  // energy, due to roundoff, is that of a bending by 1e-9 of the radius or less.
  const double t = 1e-4, far = 100.;
  const Shell shell(cylinder(1.), {{0., 0.2}, {0.7, 1.3}, {{2, 2}}, 0.1}, GetParam(), material,
                    {t});
  const auto rigid = shell.interpolate(
      [&](const Point<3> &x)
      {
        const Tensor<1, 3> axis = vector(0.6, -0.8, 1.);
        const Tensor<1, 3> u    = vector(far, -far, far) + cross_product_3d(axis, Tensor<1, 3>(x));
        return Vector6{{u[0], u[1], u[2], axis[0], axis[1], axis[2]}};
      });
  EXPECT_LT(shell.squares(rigid).first / (young * t), 1e-24);
}

TEST_P(ShellDegreesHard, UniformStatesOnHardMeshes)
{
  // Cells with an aspect ratio of 1:100, and cells with angles far from right angles.
  const ParameterMesh stretched{{0., 0.}, {1., 0.01}, {{2, 2}}, 0.05},
      strongly_distorted{{0., 0.}, {1., 1.}, {{3, 3}}, 0.2};
  for (const ParameterMesh &mesh : {stretched, strongly_distorted})
  {
    for (const double t : {0.1, 1e-3})
      expect_exact_energies(GetParam(), t, mesh, 1e-9);
    expect_no_inner_forces(GetParam(), 0.1, mesh, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, ShellDegrees, testing::Values(1, 2, 3, 4));
INSTANTIATE_TEST_SUITE_P(Degrees, ShellDegreesHard, testing::Values(1, 2, 3, 4));
