// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/newton_system.h>

#include <limits>
#include <vector>

namespace ringmotor
{
  /** The last iterate of Newton's method. */
  struct ContactIterate
  {
    ContactState state;
    std::vector<PointVector> motion; ///< gap and slip (m) by contact node
    ContactCertificate certificate;
    unsigned int n_iterations = 0; ///< linear systems solved
    bool failed = true; ///< the state is meaningless: too many nodes, or a singular system

    bool certified() const { return !failed && certificate.holds(); }
  };

  /** Stopping criteria of Newton's method. */
  struct NewtonLimits
  {
    unsigned int most_iterations = 40;
    double converged             = 1e-11; ///< of the certificate
    /** Iterations without a new smallest residual. Newton's method either reduces the residual in
     * nearly every iteration or jumps between sets of touching nodes forever. The largest violation
     * is no indicator: where a border between stick and slip moves along the ring by a tooth in
     * each iteration, it stays the same until the border has arrived. */
    unsigned int most_without_gain = 8;
    /** Touching nodes. From a start near the solution, their number does not multiply. */
    unsigned int most_touching = std::numeric_limits<unsigned int>::max();
  };

  /**
   * The semi-smooth Newton method with a line search, see NewtonSystem: steps that would increase
   * the residual are shortened. @p solver may hold factors of similar systems.
   * @param seen the motion that determines the active sets of the first system; that of @p start if
   * empty
   * @return the last iterate, whether it has converged or not
   */
  ContactIterate newton(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                        const ComplementarityConstants &constants, const ContactState &start,
                        const NewtonLimits &limits, RowSolver &solver,
                        const std::vector<PointVector> &seen = {});
} // namespace ringmotor
