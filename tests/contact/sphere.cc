// SPDX-License-Identifier: LGPL-2.1-or-later

// A sphere pressed on a plane of its material and shifted by Q, growing from zero (Cattaneo 1938,
// Mindlin 1949; Johnson 1985, section 7.2): the circle of radius c = a (1 - Q/(mu P))^(1/3) sticks,
// the sphere shifts by 3 mu P (2 - nu)/(8 a G) (1 - (1 - k)^(2/3)), k = Q/(mu P), and friction
// dissipates the work 9 (2 - nu) (mu P)^2 / (20 a G)
// (1 - (1 - k)^(5/3) - 5k/6 (1 + (1 - k)^(2/3))), a quarter of the dissipation in a cycle between
// -Q and Q (Mindlin and Deresiewicz 1953). With nu = 0 that is exact; otherwise it neglects slip
// perpendicular to Q. For the polyethylene ball of the program CONTACT (G 200 MPa, nu 0.42, R 50
// mm, a 1 mm, mu 0.4, k 7/8) the closed forms are 8.172e-3 mm and 2.755e-3 N mm, the numbers of the
// full law are 8.16e-3 mm and 2.733e-3 N mm.

#include "support/half_spaces.h"
#include "support/record.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double load = 9.1954, mu = 0.4, part = 0.875; // mm, N, MPa

  struct Shifted
  {
    ContactSolution solution;
    double shift = 0., work = 0.;
  };

  /** Q grows in equal steps. */
  Shifted shifted(const SphereOnPlane &sphere, const unsigned int n_steps)
  {
    Shifted found;
    std::vector<PointVector> before(sphere.points().size());
    for (unsigned int step = 1; step <= n_steps; ++step)
    {
      const DenseContact problem = sphere.shift(load, -part * mu * load * step / n_steps, before);
      found.solution = solve_contact(problem, coulomb(mu), sphere.constants(), problem.nothing());
      before         = found.solution.state.force;
      found.shift -= found.solution.state.rigid[1];
      for (unsigned int i = 0; i < before.size(); ++i)
        for (const unsigned int c : {1u, 2u})
          found.work -= 4. * before[i][c] * found.solution.motion[i][c];
    }
    return found;
  }

  double radius_of(const unsigned int n_squares, const SphereOnPlane &sphere)
  {
    return std::sqrt(4. * n_squares * sphere.area() / M_PI);
  }
} // namespace

TEST(Sphere, IsHertzAndMindlinWithoutPoissonsRatio)
{
  const double k = part, shear_modulus = 200. / 0.58; // the same E*
  const double left = std::pow(1. - k, 2. / 3.), force = mu * load;
  const double shift = 3. * force * 2. / (8. * shear_modulus) * (1. - left);
  const double work  = 9. * 2. * force * force / (20. * shear_modulus) *
                      (1. - (1. - k) * left - 5. * k / 6. * (1. + left));
  const SphereOnPlane sphere{shear_modulus, 0., 50., 0.05, 1.15};
  const Shifted found = shifted(sphere, 1);
  record("relative error of the shift", found.shift / shift - 1.);
  record("relative error of the friction work", found.work / work - 1.);
  EXPECT_NEAR(found.shift / shift, 1., 1e-3);
  EXPECT_NEAR(found.work / work, 1., 2e-3);
  const ContactSolution &solution = found.solution;
  const unsigned int n_touching   = solution.status.size() - count(solution, PointStatus::open);
  EXPECT_NEAR(radius_of(n_touching, sphere), 1., sphere.width);
  EXPECT_NEAR(radius_of(count(solution, PointStatus::stick), sphere), 0.5, sphere.width);
  EXPECT_NEAR(solution.state.force[0][0] / sphere.area(), 1.5 * load / M_PI, 5e-3);
  EXPECT_NEAR(solution.state.rigid[0], 0.02, 1e-5); // a^2/R
}

TEST(Sphere, IsThatOfContactWithPoissonsRatio)
{
  const SphereOnPlane sphere{200., 0.42, 50., 0.05, 1.15};
  const Shifted found = shifted(sphere, 1);
  record("shift (mm)", found.shift);
  record("friction work (N mm)", found.work);
  record("radius of the stick zone (mm)",
         radius_of(count(found.solution, PointStatus::stick), sphere));
  EXPECT_NEAR(found.shift, 8.16e-3, 0.005e-3);
  EXPECT_NEAR(found.work / 2.733e-3, 1., 2e-3);
  EXPECT_NEAR(radius_of(count(found.solution, PointStatus::stick), sphere), 0.5, sphere.width);
}

TEST(Sphere, HardlyRemembersItsSteps)
{
  // The direction of friction turns a little while Q grows.
  const SphereOnPlane sphere{200., 0.42, 50., 0.1, 1.15};
  const Shifted once = shifted(sphere, 1), slowly = shifted(sphere, 8);
  EXPECT_NEAR(slowly.shift / once.shift, 1., 1e-4);
  EXPECT_NEAR(slowly.work / once.work, 1., 1e-3);
}
