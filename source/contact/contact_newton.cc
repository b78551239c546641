// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/contact_newton.h>

#include <limits>

namespace ringmotor
{
  ContactIterate newton(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                        const ComplementarityConstants &constants, const ContactState &start,
                        const unsigned int most_iterations)
  {
    constexpr double converged = 1e-11; // of certificates
    ContactIterate iterate;
    iterate.state               = start;
    iterate.motion              = problem.relative_motion(start);
    iterate.certificate.balance = std::numeric_limits<double>::infinity();
    while (iterate.n_iterations < most_iterations)
    {
      const NewtonSystem system(problem, bound_of, constants, iterate.state, iterate.motion);
      ++iterate.n_iterations;
      iterate.failed = !system.solve(iterate.state);
      if (iterate.failed)
        break;
      iterate.motion      = problem.relative_motion(iterate.state);
      const double before = iterate.certificate.worst();
      iterate.certificate = certify(problem, bound_of, iterate.state, iterate.motion);
      const double worst  = iterate.certificate.worst();
      // No better than before: rounding is all that is left.
      if (worst <= converged || (iterate.certificate.holds() && worst >= before))
        break;
    }
    return iterate;
  }
} // namespace ringmotor
