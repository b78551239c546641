// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/newton_system.h>

#include <limits>
#include <vector>

namespace ringmotor
{
  /** What Newton's method left. */
  struct ContactIterate
  {
    ContactState state;
    std::vector<PointVector> motion; ///< gap and slip (m) by contact node
    ContactCertificate certificate;
    unsigned int n_iterations = 0; ///< linear systems solved
    bool failed = true; ///< nothing is known of the state: too many nodes, or a singular system

    bool certified() const { return !failed && certificate.holds(); }
  };

  /** When Newton's method ends. */
  struct NewtonLimits
  {
    unsigned int most_iterations = 40;
    double converged             = 1e-11; ///< of the certificate
    /** Iterations without a smaller residual than ever before. Newton's method gains in nearly
     * every iteration, or jumps from one set of touching nodes to another for ever. The largest
     * violation does not tell: where a border between stick and slip moves along the ring by a
     * tooth in each iteration, it stays the same until the border has arrived. */
    unsigned int most_without_gain = 8;
    /** Touching nodes. From a start that is near the solution they do not become many times more.
     */
    unsigned int most_touching = std::numeric_limits<unsigned int>::max();
  };

  /**
   * The semi-smooth Newton method with a line search, see NewtonSystem: of each step it takes as
   * much as brings the equations closer to being fulfilled. @p solver may know factors of like
   * systems.
   * @param seen the motion by which the first system is chosen; that of @p start if empty
   * @return the last iterate, whether it has converged or not
   */
  ContactIterate newton(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                        const ComplementarityConstants &constants, const ContactState &start,
                        const NewtonLimits &limits, RowSolver &solver,
                        const std::vector<PointVector> &seen = {});
} // namespace ringmotor
