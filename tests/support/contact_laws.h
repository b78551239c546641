// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "support/dense_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ringmotor::tests
{
  /**
   * How far a state is from Coulomb's law, contact and balance, relative to the largest force,
   * computed independently of the solver's certificate: p = max(0, p - c gap), and F_t is
   * F_t - c slip projected to the disc of radius mu p, for a stiffness @p c (N/m) of any size.
   */
  inline double violation(const ContactProblem &problem, const double mu, const ContactState &state,
                          const double c)
  {
    const std::vector<PointVector> motion = problem.relative_motion(state);
    double largest = 0., force = 0.;
    for (unsigned int i = 0; i < motion.size(); ++i)
    {
      const PointVector &f = state.force[i];
      const PointVector to = f - c * motion[i];
      const double bound = mu * std::max(0., f[0]), size = std::hypot(to[1], to[2]);
      const double shrink = size > bound ? bound / size : 1.;
      const double defect = std::abs(f[0] - std::max(0., to[0])) +
                            std::hypot(f[1] - shrink * to[1], f[2] - shrink * to[2]);
      largest = defect <= largest ? largest : defect; // keeps a NaN
      force   = std::max(force, f.norm());
    }
    for (const double balance : problem.balances(state))
      largest = std::abs(balance) <= largest ? largest : std::abs(balance);
    return force > 0. ? largest / force : largest;
  }

  /** Solves with a coefficient of friction, and checks the solution. */
  inline ContactSolution expect_solved(const DenseContact &problem, const double mu,
                                       const ComplementarityConstants &constants,
                                       const ContactState &start)
  {
    const ContactSolution found = solve_contact(problem, coulomb(mu), constants, start);
    EXPECT_TRUE(found.certificate.holds());
    EXPECT_LT(violation(problem, mu, found.state, constants.normal), 1e-7);
    return found;
  }
} // namespace ringmotor::tests
