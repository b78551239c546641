// SPDX-License-Identifier: LGPL-2.1-or-later

// Cylinders that roll steadily, as elastic half-planes in strips:
// - Carter 1926, equal materials: creep = - mu a/R (1 - sqrt(1 - Fx/(mu P))) for a force Fx of the
//   lower body on the upper one, and the part sqrt(1 - Fx/(mu P)) of the contact, which begins at
//   the leading edge, sticks. With R 500 mm, a 1 mm, mu 0.3, creep -2.4e-4: Fx = 0.64 mu P, 0.6.
//   With 50, 100, 200 and 400 strips the program CONTACT has 0.6445, 0.6423, 0.6411, 0.6406 (user
//   guide, section on the 2D Carter/Fromm problem).
// - Bentall and Johnson 1967, an aluminium roller on a steel roller. Closed forms without a
//   tangential force, with Dundurs' beta, K = beta a/R and e = atanh(beta)/pi: without friction the
//   pressure level above which half of the load is carried determines the creep = K sqrt(1 - t^2),
//   asin t + t sqrt(1 - t^2) = pi/4. Without slip Muskhelishvili's function X = (z + a)^(1/2 + i e)
//   (z - a)^(1/2 - i e) = z + 2 i e a - (1/2 + 2 e^2) a^2/z + ... solves the problem:
//   creep = 2 e a/R under the load (1 + 4 e^2) pi E* a^2/(4 R). The example of CONTACT with 200
//   strips in the contact: creep 5.260e-4 (mu 1e-4) and 3.591e-4 (mu 10), which is still 2 % below
//   the limit of fine meshes; with mu 0.05 and Fx/(mu P) of 0, 0.75 and -0.75 creep 4.294e-4,
//   2.108e-4, 5.392e-4 and friction power 9.475e-3, 0.1955, 4.418e-2 W at 1 m width and 1 m/s (four
//   digits, its iterations end at 2.4e-4).

#include "support/half_planes.h"
#include "support/record.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  // mm, N, MPa
  constexpr HalfPlanes steel{82000., 0.28, 82000., 0.28},
      aluminium_on_steel{23000., 0.31, 82000., 0.28};

  double beta()
  {
    return aluminium_on_steel.mismatch() / (2. * aluminium_on_steel.compliance());
  }

  /** Strips aligned with the edges of the contact by Hertz, with @p n_beyond more on either side.
   */
  LineContact rollers(const HalfPlanes &bodies, const double radius, const double half_width,
                      const unsigned int n_touching, const unsigned int n_beyond)
  {
    const double width   = 2. * half_width / n_touching;
    const unsigned int n = n_touching + 2 * n_beyond;
    return {bodies, radius, -0.5 * (n - 1) * width, width, n};
  }

  double hertz_load(const LineContact &line, const double half_width)
  {
    return M_PI * half_width * half_width / (4. * line.radius * line.bodies.compliance());
  }

  /** The work lost to friction while the contact rolls by one strip, from the means of the forces
   * before and after, or from those after. */
  double dissipation(const ContactSolution &solution, const bool means)
  {
    double sum = 0.;
    PointVector before;
    for (unsigned int i = 0; i < solution.motion.size(); ++i)
    {
      const PointVector &now = solution.state.force[i];
      sum -= (means ? 0.5 * (now[1] + before[1]) : now[1]) * solution.motion[i][1];
      before = now;
    }
    return sum;
  }

  /** The work of the pressure on the curvature of the surfaces as they roll by one strip; nonzero
   * if the pressure is not symmetric. */
  double work_of_pressure(const DenseContact &problem, const ContactSolution &solution)
  {
    double sum = 0.;
    for (unsigned int i = 1; i < solution.motion.size(); ++i)
      sum += 0.5 * (solution.state.force[i][0] + solution.state.force[i - 1][0]) *
             (problem.free_motion[i][0] - solution.motion[i][0] - problem.free_motion[i - 1][0] +
              solution.motion[i - 1][0]);
    return sum;
  }
} // namespace

TEST(Rolling, IsCarter)
{
  constexpr double mu = 0.3, creep = -2.4e-4;
  double coarser = 0., finer = 0.;
  for (const auto &[n, contact] : {std::pair(50u, 0.6445), std::pair(100u, 0.6423),
                                   std::pair(200u, 0.6411), std::pair(400u, 0.6406)})
  {
    const LineContact line     = rollers(steel, 500., 1., n, 2);
    const double load          = hertz_load(line, 1.);
    const DenseContact problem = line.rolling_with_creep(load, creep);
    const ContactSolution found =
        solve_contact(problem, coulomb(mu), line.constants(), problem.nothing());
    const double force = total(found.state, 1);
    coarser            = finer;
    finer              = force / (mu * load);
    record("force over mu P, 50, 100, 200, 400 strips", finer);
    EXPECT_NEAR(finer, contact, 0.5e-4);
    EXPECT_EQ(count(found, PointStatus::stick), 3 * n / 5);
    for (unsigned int i = 2; i < 2 + 3 * n / 5; ++i)
      EXPECT_EQ(found.status[i], PointStatus::stick);
    EXPECT_NEAR(dissipation(found, true) / (-creep * line.width * force), 1., 1e-9);
  }
  record("force over mu P, extrapolated", 2. * finer - coarser);
  EXPECT_NEAR(2. * finer - coarser, 0.64, 1e-4);
}

TEST(Rolling, FindsTheCreepOfAForce)
{
  constexpr double mu = 0.3;
  for (const double part : {0., 0.19, 0.64, 0.96})
  {
    const LineContact line     = rollers(steel, 500., 1., 200, 2);
    const double load          = hertz_load(line, 1.);
    const DenseContact problem = line.rolling(load, -part * mu * load);
    const ContactSolution found =
        solve_contact(problem, coulomb(mu), line.constants(), problem.nothing());
    EXPECT_NEAR(found.state.rigid[1], -mu / 500. * (1. - std::sqrt(1. - part)), 0.01 * mu / 500.)
        << part;
  }
}

TEST(Rolling, IsBentallAndJohnson)
{
  constexpr double half_width = 0.1, radius = 25.;
  const LineContact line = rollers(aluminium_on_steel, radius, half_width, 200, 8);
  const double load      = hertz_load(line, half_width);
  const auto solve       = [&](const double mu, const double part)
  {
    const double force         = part * mu * load;
    const DenseContact problem = line.rolling(load, -force);
    const ContactSolution found =
        solve_contact(problem, coulomb(mu), line.constants(), problem.nothing());
    const double creep = found.state.rigid[1];
    EXPECT_NEAR(dissipation(found, true),
                -creep * line.width * force - work_of_pressure(problem, found),
                1e-9 * mu * load * line.width * creep);
    return found;
  };
  const double smooth = solve(1e-4, 0.).state.rigid[1];
  record("creep, mu = 1e-4, no force", smooth);
  EXPECT_NEAR(smooth / 5.260e-4, 1., 5e-4);
  double low = 0., high = 1.; // t
  for (unsigned int i = 0; i < 60; ++i)
  {
    const double t                                                        = 0.5 * (low + high);
    (std::asin(t) + t * std::sqrt(1. - t * t) < 0.25 * M_PI ? low : high) = t;
  }
  EXPECT_NEAR(smooth / (beta() * half_width / radius * std::sqrt(1. - low * low)), 1., 1e-3);
  const double without_slip = solve(10., 0.).state.rigid[1];
  record("creep, mu = 10, no force", without_slip);
  EXPECT_NEAR(without_slip / 3.591e-4, 1., 5e-4);

  struct Case
  {
    double part, creep, power;
    unsigned int n_stuck;
  };
  for (const Case &expected :
       {Case{0., 4.294e-4, 9.475e-6, 125}, Case{0.75, 2.108e-4, 1.955e-4, 36},
        Case{-0.75, 5.392e-4, 4.418e-5, 106}})
  {
    const ContactSolution found = solve(0.05, expected.part);
    record("creep, mu = 0.05, Fx/(mu P) = 0, 0.75, -0.75", found.state.rigid[1]);
    record("friction power, the same (mW at 1 m width and 1 m/s)",
           1e6 * dissipation(found, false) / line.width);
    EXPECT_NEAR(found.state.rigid[1] / expected.creep, 1., 5e-4);
    EXPECT_NEAR(dissipation(found, false) / line.width / expected.power, 1., 5e-4);
    EXPECT_NEAR(count(found, PointStatus::stick), expected.n_stuck, 1);
  }
}

TEST(Rolling, HasTheCreepWithoutSlipInTheLimit)
{
  constexpr double half_width = 0.1, radius = 25.;
  const double e = std::atanh(beta()) / M_PI;
  std::vector<double> creep;
  for (const unsigned int n : {50u, 100u, 200u})
  {
    // The edges of the contact coincide with mesh lines.
    const LineContact line     = rollers(aluminium_on_steel, radius, half_width, n, 0);
    const double load          = (1. + 4. * e * e) * hertz_load(line, half_width);
    const DenseContact problem = line.rolling(load, 0.);
    const ContactSolution found =
        solve_contact(problem, coulomb(10.), line.constants(), problem.nothing());
    EXPECT_EQ(count(found, PointStatus::stick), n);
    creep.push_back(found.state.rigid[1] / (2. * e * half_width / radius));
  }
  const double step  = creep[2] - creep[1];
  const double limit = creep[2] + step * step / (creep[1] - creep[0] - step); // Aitken
  record("creep over its closed form, extrapolated", limit);
  EXPECT_NEAR(limit, 1., 2e-3);
}
