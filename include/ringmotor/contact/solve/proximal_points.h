// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_newton.h>

namespace ringmotor
{
  /**
   * The proximal point algorithm: a chain of problems with springs, each of which starts from the
   * solution of the previous one; where Newton's method fails the springs are made stronger, where
   * it succeeds weaker. When the laws are nearly fulfilled, Newton's method finishes without them.
   * @param most_points problems of the chain, whether they are solved or not
   */
  ContactIterate proximal_points(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                                 const ComplementarityConstants &constants,
                                 const ContactState &start, RowSolver &solver,
                                 const unsigned int most_points);
} // namespace ringmotor
