// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/friction.h>
#include <ringmotor/contact/solve/contact_newton.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** The contact at the end of a step: what the next step, or the search for a similar state,
   * starts from. */
  struct StepState
  {
    ContactState state;
    std::vector<PointVector> motion;    ///< gap and slip (m) by point; empty if not known
    std::vector<FrictionMemory> memory; ///< by point, at the begin of the step
    double speed = 0.;                  ///< rad/s, of the rotor
    std::vector<PointStatus> status;
  };

  /** The solution of a contact problem, without memory and speed, of which it knows nothing. */
  struct ContactSolution : StepState
  {
    ContactCertificate certificate;
    unsigned int n_iterations = 0; ///< linear problems solved
    std::string how;               ///< what was tried, in words, if Newton's method alone failed
  };

  /** What to do where Newton's method fails. */
  enum class Fallback
  {
    proximal_points,
    few_proximal_points, ///< a chain of a dozen at most
    none
  };

  /**
   * Solves a contact problem with friction by the semi-smooth Newton method. Where it does not
   * converge, or @p start has no forces, the proximal point algorithm leads it to the solution.
   *
   * @param seen gaps and slips of a similar problem in the state @p start, where they are known:
   * the first guess of the touching and the sticking nodes
   * @param solver keeps factors of the linear systems for similar problems
   * @throws ComputationError if no method converged to a certified state.
   */
  ContactSolution solve_contact(const ContactProblem &problem, const PointFriction &friction,
                                const ComplementarityConstants &constants,
                                const ContactState &start, const std::vector<PointVector> &seen,
                                RowSolver &solver,
                                const Fallback fallback = Fallback::proximal_points);
  ContactSolution solve_contact(const ContactProblem &problem, const PointFriction &friction,
                                const ComplementarityConstants &constants,
                                const ContactState &start);

  /** The same without friction. */
  ContactSolution solve_without_friction(const ContactProblem &problem,
                                         const ComplementarityConstants &constants,
                                         const ContactState &start);
} // namespace ringmotor
