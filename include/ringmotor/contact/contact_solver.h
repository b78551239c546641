// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_newton.h>
#include <ringmotor/contact/friction.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** The solution of a contact problem. */
  struct ContactSolution
  {
    ContactState state;
    std::vector<PointVector> motion; ///< gap and slip (m) by point
    std::vector<PointStatus> status;
    ContactCertificate certificate;
    unsigned int n_iterations = 0; ///< linear problems solved
    std::string how;               ///< what was tried, in words, if Newton's method alone failed
  };

  /** What follows where Newton's method fails. */
  enum class Fallback
  {
    proximal_points,
    none
  };

  /**
   * Solves a contact problem with friction by the semi-smooth Newton method. Where its iterates do
   * not settle, or @p start has no forces, the proximal point algorithm leads it to the solution.
   *
   * @param seen gaps and slips of a like problem in the state @p start, where they are known: the
   * first guess of what touches and what sticks
   * @param solver keeps what it knows of the linear systems for problems that are alike
   * @throws ComputationError if nothing converged to a state that certifies.
   */
  ContactSolution solve_contact(const ContactProblem &problem, const PointFriction &friction,
                                const ComplementarityConstants &constants,
                                const ContactState &start, const std::vector<PointVector> &seen,
                                RowSolver &solver,
                                const Fallback fallback = Fallback::proximal_points);
  ContactSolution solve_contact(const ContactProblem &problem, const PointFriction &friction,
                                const ComplementarityConstants &constants,
                                const ContactState &start);

  /** The same with surfaces that know no friction. */
  ContactSolution solve_without_friction(const ContactProblem &problem,
                                         const ComplementarityConstants &constants,
                                         const ContactState &start);
} // namespace ringmotor
