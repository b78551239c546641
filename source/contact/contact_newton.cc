// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/contact_newton.h>

#include <limits>

namespace ringmotor
{
  ContactIterate newton(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                        const ComplementarityConstants &constants, const ContactState &start,
                        const NewtonLimits &limits)
  {
    ContactIterate iterate;
    iterate.state        = start;
    iterate.motion       = problem.relative_motion(start);
    double smallest      = std::numeric_limits<double>::infinity();
    unsigned int of_gain = 0; // iteration of the last gain
    while (iterate.n_iterations < limits.most_iterations)
    {
      const NewtonSystem system(problem, bound_of, constants, iterate.state, iterate.motion);
      ++iterate.n_iterations;
      iterate.failed = !system.solve(iterate.state);
      if (iterate.failed)
        break;
      iterate.motion      = problem.relative_motion(iterate.state);
      iterate.certificate = certify(problem, bound_of, iterate.state, iterate.motion);
      const double worst  = iterate.certificate.worst();
      const bool gains    = worst < smallest;
      // Without a gain below the limit of certificates rounding is all that is left.
      if (worst <= limits.converged || (iterate.certificate.holds() && !gains) ||
          (!gains && iterate.n_iterations >= of_gain + limits.most_without_gain))
        break;
      if (gains)
      {
        smallest = worst;
        of_gain  = iterate.n_iterations;
      }
    }
    return iterate;
  }
} // namespace ringmotor
