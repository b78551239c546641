// SPDX-License-Identifier: LGPL-2.1-or-later

// Random contact problems: that those with one solution are solved, and that no wrong state is
// accepted as a solution. How many Newton's method solves alone is recorded.

#include "support/random_contact.h"
#include "support/contact_laws.h"
#include "support/record.h"

#include <ringmotor/contact/solve/contact_newton.h>
#include <ringmotor/parameters/errors.h>

#include <gtest/gtest.h>

using namespace ringmotor;
using namespace ringmotor::tests;

TEST(ContactHard, ByNewtonsMethodAlone)
{
  // Much friction and strong coupling: some 70 % of these problems are solved, 60 % with full
  // Newton steps. What is said to be solved must be.
  constexpr double mu               = 3.;
  constexpr unsigned int n_problems = 300;
  const FrictionBoundOf bound_of    = [&](const unsigned int, const double pressed, const double) {
    return FrictionBound{mu * pressed, mu, 0.};
  };
  random_numbers.seed(1);
  double share = 0.;
  for (unsigned int k = 0; k < n_problems; ++k)
  {
    const DenseContact problem = random_problem(20, 0.3, false);
    RowSolver solver;
    const ContactIterate found =
        newton(problem, bound_of, constants_of(problem), problem.nothing(), {}, solver);
    share += found.certified() / double(n_problems);
    if (found.certified())
    {
      EXPECT_LT(violation(problem, mu, found.state, constants_of(problem).normal), 1e-7);
    }
  }
  record("share of problems solved", share);
  EXPECT_GT(share, 0.66);
}

TEST(ContactHard, OfAnyCompliance)
{
  random_numbers.seed(1);
  double n_solved = 0, n_helped = 0;
  for (const unsigned int n_points : {1u, 3u, 10u, 30u})
    for (const double coupling : {0., 0.5, 1.})
      for (const bool rigid_motions : {false, true})
        for (const double mu : {0.05, 0.2, 0.5, 1.})
          for (unsigned int i = 0; i < 120 / n_points; ++i)
          {
            DenseContact problem = random_problem(n_points, coupling, rigid_motions);
            if (rigid_motions)
              problem.load = {-0.3 * n_points, 0.3 * mu * n_points * random(-0.9, 0.9)};
            const ContactSolution found =
                expect_solved(problem, mu, constants_of(problem), problem.nothing());
            if (rigid_motions) // no initial contact constrains them
              continue;
            ++n_solved;
            n_helped += !found.how.empty();
          }
  record("share not solved by Newton's method alone", n_helped / n_solved);
}

TEST(ContactHard, IsRefusedRatherThanWrong)
{
  // Friction beyond realistic values; most problems have a solution, but it need not be found.
  random_numbers.seed(1);
  unsigned int n_solved = 0;
  for (unsigned int i = 0; i < 100; ++i)
  {
    const DenseContact problem = random_problem(10, 1., false);
    try
    {
      expect_solved(problem, 5., constants_of(problem), problem.nothing());
      ++n_solved;
    }
    catch (const ComputationError &)
    {
    }
  }
  EXPECT_GT(n_solved, 80u);
}
