// SPDX-License-Identifier: LGPL-2.1-or-later

// Cylinders pressed together and shifted, as elastic half-planes in strips of constant pressure:
// - Hertz: a^2 = 4 P R / (pi E*), p = p0 sqrt(1 - x^2/a^2), p0 = 2 P / (pi a);
// - Cattaneo 1938, Mindlin 1949: a tangential force Q leaves the middle of half width
//   c = a sqrt(1 - Q/(mu P)) stuck; friction is mu p minus (c/a) mu p0 sqrt(1 - x^2/c^2) there
//   (Johnson 1985, section 7.2).
// The answer must not depend on the constants of the method or the units.

#include "support/half_planes.h"
#include "support/record.h"

#include <ringmotor/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  // mm, N, MPa
  constexpr double half_width = 1., radius = 500., mu = 0.3;
  constexpr HalfPlanes steel{82000., 0.28, 82000., 0.28};

  const double load = M_PI * half_width * half_width / (4. * radius * steel.compliance());

  /** @param n_touching strips in the contact by Hertz */
  LineContact cylinders(const unsigned int n_touching)
  {
    const double width   = 2. * half_width / n_touching;
    const unsigned int n = n_touching + n_touching / 10;
    return {steel, radius, -0.5 * (n - 1) * width, width, n};
  }

  ContactSolution solve(const LineContact &line, const DenseContact &problem)
  {
    return solve_contact(problem, coulomb(mu), line.constants(), problem.nothing());
  }
} // namespace

TEST(LineContact, IsHertz)
{
  for (const unsigned int n : {20u, 50u, 100u})
  {
    const LineContact line      = cylinders(n);
    const ContactSolution found = solve(line, line.shift(load, 0.));
    const double touching       = line.width * (line.n_strips - count(found, PointStatus::open));
    record("half width over a, 20, 50, 100 strips", 0.5 * touching);
    record("relative error of the peak pressure, 20, 50, 100 strips",
           found.state.force[line.n_strips / 2][0] * M_PI * half_width / (2. * load * line.width) -
               1.);
    EXPECT_NEAR(0.5 * touching, half_width, line.width);
    const double p0 = 2. * load / (M_PI * half_width);
    for (unsigned int i = 0; i < line.n_strips; ++i)
    {
      if (std::abs(line.x(i)) > half_width - line.width)
        continue;
      EXPECT_NEAR(found.state.force[i][0] / line.width,
                  p0 * std::sqrt(1. - std::pow(line.x(i) / half_width, 2)), 2. * p0 / n);
    }
    EXPECT_NEAR(found.state.force[line.n_strips / 2][0] / line.width / p0, 1., 2e-3);
    EXPECT_NEAR(total(found.state, 0), load, 1e-9 * load);
  }
}

TEST(LineContact, IsCattaneoMindlin)
{
  for (const double part : {0.1, 0.36, 0.64, 0.91, 0.99})
  {
    const LineContact line      = cylinders(100);
    const ContactSolution found = solve(line, line.shift(load, -part * mu * load));
    const double stuck          = half_width * std::sqrt(1. - part);
    record("half width of the stick zone over a, Q/(mu P) = 0.1, 0.36, 0.64, 0.91, 0.99",
           0.5 * line.width * count(found, PointStatus::stick));
    EXPECT_NEAR(0.5 * line.width * count(found, PointStatus::stick), stuck, line.width) << part;
    EXPECT_NEAR(total(found.state, 1), part * mu * load, 1e-9 * load);
    EXPECT_LT(found.state.rigid[1], 0.); // friction along t on the upper body: it moved along -t
    const double q0 = mu * 2. * load / (M_PI * half_width);
    for (unsigned int i = 0; i < line.n_strips; ++i)
    {
      const double x = line.x(i), p = found.state.force[i][0] / line.width;
      const double less  = std::abs(x) < stuck ? q0 * std::sqrt(stuck * stuck - x * x) : 0.;
      const bool is_even = std::abs(std::abs(x) - stuck) > line.width;
      EXPECT_NEAR(found.state.force[i][1] / line.width, mu * p - less, (is_even ? 0.01 : 0.1) * q0)
          << part << " " << x;
      EXPECT_NEAR(found.state.force[i][2], 0., 1e-12 * load);
    }
  }
}

TEST(LineContact, ForgetsTheConstants)
{
  const LineContact line = cylinders(50);
  for (const bool rolls : {false, true})
  {
    const double tangential_load = -0.64 * mu * load;
    const DenseContact problem =
        rolls ? line.rolling(load, tangential_load) : line.shift(load, tangential_load);
    const ContactSolution expected = solve(line, problem);
    for (const double normal : {1e-2, 1e-1, 1., 10., 100.})
      for (const double tangential : {1e-2, 1e-1, 1., 10., 100.})
      {
        ComplementarityConstants constants = line.constants();
        constants.normal *= normal;
        constants.tangential *= tangential;
        const ContactSolution found =
            solve_contact(problem, coulomb(mu), constants, problem.nothing());
        for (unsigned int i = 0; i < line.n_strips; ++i)
          EXPECT_LT((found.state.force[i] - expected.state.force[i]).norm(), 1e-9 * load)
              << rolls << " " << normal << " " << tangential;
      }
  }
}

TEST(LineContact, ForgetsTheUnits)
{
  const LineContact in_mm = cylinders(50);
  LineContact in_m        = in_mm;
  for (double *length : {&in_m.radius, &in_m.first, &in_m.width})
    *length *= 1e-3;
  for (double *modulus : {&in_m.bodies.shear_modulus_upper, &in_m.bodies.shear_modulus_lower})
    *modulus *= 1e6;
  const double thickness      = 1e3; // 1 m in mm
  const ContactSolution small = solve(in_mm, in_mm.rolling(load, -0.5 * mu * load)),
                        large = solve(in_m,
                                      in_m.rolling(thickness * load, -0.5 * mu * thickness * load));
  EXPECT_EQ(small.status, large.status);
  EXPECT_NEAR(large.state.rigid[0] / small.state.rigid[0], 1e-3, 1e-12);
  EXPECT_NEAR(large.state.rigid[1] / small.state.rigid[1], 1., 1e-9);
  for (unsigned int i = 0; i < in_mm.n_strips; ++i)
    EXPECT_LT((large.state.force[i] / thickness - small.state.force[i]).norm(), 1e-10 * load);
}
