// SPDX-License-Identifier: LGPL-2.1-or-later

// Small problems solved by hand:
// - a block of weight G that a horizontal force F pushes up a plane of inclination alpha slides at
//   F/G = (tan alpha + mu)/(1 - mu tan alpha);
// - a particle on springs beside an obstacle (Klarbring 1990), stiffness ((1, 2), (2, 5)) and load
//   (0.55, 1) along and towards the obstacle: u_t = 0.75 + 5 r_t + 2 p, gap = 0.1 + 2 r_t + p with
//   the friction r_t. It is in equilibrium away from the obstacle for any mu; with mu 0.6 also
//   where it sticks (p = 1, r_t = -0.55) and where it slips (u_t = 0.25, p = 0.5).

#include "support/contact_laws.h"
#include "support/record.h"

#include <ringmotor/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double slope = 0.1, weight = 20.;

  /**
   * A block on three points of a plane that rises along t. Rigid motions: upwards and, if @p push
   * (N) is given, horizontal; otherwise it moves upwards by a horizontal distance of 1e-6 m.
   */
  DenseContact block(const double *push)
  {
    const double c = 1. / std::sqrt(1. + slope * slope), s = slope * c;
    DenseContact problem(3, push ? 2 : 1);
    problem.load[0] = -weight;
    for (unsigned int i = 0; i < 3; ++i)
    {
      for (unsigned int d = 0; d < 3; ++d)
        problem.compliance(3 * i + d, 3 * i + d) = 1e-8 * (i + 1.);
      problem.rigid_motion(3 * i, 0)     = c;
      problem.rigid_motion(3 * i + 1, 0) = s;
      problem.balance(0, 3 * i)          = c;
      problem.balance(0, 3 * i + 1)      = s;
      if (!push)
      {
        problem.free_motion[i][0] = -1e-6 * s;
        problem.free_motion[i][1] = 1e-6 * c;
        continue;
      }
      problem.load[1]                    = *push;
      problem.rigid_motion(3 * i, 1)     = -s;
      problem.rigid_motion(3 * i + 1, 1) = c;
      problem.balance(1, 3 * i)          = -s;
      problem.balance(1, 3 * i + 1)      = c;
    }
    return problem;
  }

  constexpr ComplementarityConstants of_block{5e7, 5e7};

  DenseContact particle()
  {
    DenseContact problem(1, 0);
    problem.compliance(0, 0)  = 1.;
    problem.compliance(0, 1)  = 2.;
    problem.compliance(1, 0)  = 2.;
    problem.compliance(1, 1)  = 5.;
    problem.compliance(2, 2)  = 1.;
    problem.free_motion[0][0] = 0.1;
    problem.free_motion[0][1] = 0.75;
    return problem;
  }

  ContactSolution solve_particle(const double mu, const double p, const double r_t)
  {
    const DenseContact problem  = particle();
    ContactState start          = problem.nothing();
    start.force[0][0]           = p;
    start.force[0][1]           = r_t;
    const ContactSolution found = solve_contact(problem, coulomb(mu), {1., 0.2}, start);
    EXPECT_TRUE(found.certificate.holds());
    EXPECT_LT(violation(problem, mu, found.state, 1.), 1e-9) << mu << " " << p << " " << r_t;
    return found;
  }
} // namespace

TEST(Wedge, Slides)
{
  for (const auto &[mu, force] : {std::pair(0.1, 0.202020202), std::pair(0.2, 0.306122449)})
  {
    const DenseContact problem  = block(nullptr);
    const ContactSolution found = solve_contact(problem, coulomb(mu), of_block, problem.nothing());
    const double c = 1. / std::sqrt(1. + slope * slope), s = slope * c;
    const double pushed = (s * total(found.state, 0) - c * total(found.state, 1)) / weight;
    record("error of the force over the weight, mu = 0.1, 0.2", pushed - force);
    EXPECT_NEAR(pushed, force, 1e-8);
    EXPECT_EQ(count(found, PointStatus::slip), 3u);
  }
}

TEST(Wedge, SticksBelowThatForceAndHasNoBalanceAboveIt)
{
  const double limit = weight * 0.306122449;
  for (const double part : {0.2, 0.9, 0.999})
  {
    const double push           = part * limit;
    const DenseContact problem  = block(&push);
    const ContactSolution found = solve_contact(problem, coulomb(0.2), of_block, problem.nothing());
    EXPECT_LT(violation(problem, 0.2, found.state, 1e7), 1e-9) << part;
    EXPECT_GT(count(found, PointStatus::stick), 0u);
  }
  for (const double part : {1.001, 1.5, 100.})
  {
    const double push          = part * limit;
    const DenseContact problem = block(&push);
    EXPECT_THROW(solve_contact(problem, coulomb(0.2), of_block, problem.nothing()),
                 ComputationError)
        << part;
  }
}

TEST(Particle, HasOneSolutionAtLittleFriction)
{
  for (const double p : {0., 0.2, 0.5, 1., 5.})
    for (const double r_t : {-1., -0.55, -0.3, 0., 0.5})
    {
      const ContactSolution found = solve_particle(0.4, p, r_t);
      EXPECT_EQ(found.status[0], PointStatus::open) << p << " " << r_t;
      EXPECT_NEAR(found.motion[0][0], 0.1, 1e-12);
      EXPECT_NEAR(found.motion[0][1], 0.75, 1e-12);
    }
}

TEST(Particle, HasThreeSolutionsAtMuchFriction)
{
  std::map<PointStatus, unsigned int> n_found;
  for (double p = 0.; p < 2.; p += 0.125)
    for (double r_t = -1.; r_t < 0.5; r_t += 0.125)
    {
      const ContactSolution found = solve_particle(0.6, p, r_t);
      const PointVector &force = found.state.force[0], &motion = found.motion[0];
      ++n_found[found.status[0]];
      if (found.status[0] == PointStatus::open)
      {
        EXPECT_NEAR(motion[0], 0.1, 1e-9);
        EXPECT_NEAR(motion[1], 0.75, 1e-9);
      }
      else if (found.status[0] == PointStatus::stick)
      {
        EXPECT_NEAR(force[0], 1., 1e-9);
        EXPECT_NEAR(force[1], -0.55, 1e-9);
      }
      else
      {
        EXPECT_NEAR(force[0], 0.5, 1e-8);
        EXPECT_NEAR(motion[1], 0.25, 1e-8);
      }
    }
  EXPECT_GT(n_found[PointStatus::open], 0u);
  EXPECT_GT(n_found[PointStatus::stick], 0u);
  EXPECT_GT(n_found[PointStatus::slip], 0u);
}
