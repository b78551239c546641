// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "support/dense_contact.h"

#include <random>

namespace ringmotor::tests
{
  inline std::mt19937 random_numbers;

  inline double random(const double from, const double to)
  {
    return from + (to - from) * std::generate_canonical<double, 53>(random_numbers);
  }

  /**
   * Random positive definite compliance, gaps and slips; normal and tangential motions are coupled
   * as strongly as motions in one direction. The complementarity constants are of the right order.
   */
  inline DenseContact random_problem(const unsigned int n_points, const double coupling,
                                     const bool rigid_motions)
  {
    DenseContact problem(n_points, rigid_motions ? 2 : 0);
    const unsigned int size = 3 * n_points;
    dealii::FullMatrix<double> factor(size, size);
    for (unsigned int i = 0; i < size; ++i)
      for (unsigned int j = 0; j < size; ++j)
        factor(i, j) =
            (i == j) + random(-0.5, 0.5) * ((i % 3 == 0) == (j % 3 == 0) ? 1. : coupling);
    factor.mTmult(problem.compliance, factor);
    for (PointVector &motion : problem.free_motion)
      for (unsigned int c = 0; c < 3; ++c)
        motion[c] = random(-2., 2.);
    for (unsigned int i = 0; rigid_motions && i < n_points; ++i)
      for (const unsigned int r : {0u, 1u})
      {
        problem.rigid_motion(3 * i + r, r) = 1.;
        problem.balance(r, 3 * i + r)      = 1.;
      }
    return problem;
  }

  inline ComplementarityConstants constants_of(const DenseContact &problem)
  {
    const double stiffness = 1. / problem.compliance.frobenius_norm();
    return {stiffness, stiffness};
  }
} // namespace ringmotor::tests
