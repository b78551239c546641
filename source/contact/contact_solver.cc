// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/contact_solver.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    constexpr unsigned int most_newton        = 40;
    constexpr unsigned int most_from_smoothed = 15;
    constexpr unsigned int n_smoothings       = 10;

    /**
     * Newton's method from states of smoothed friction that is smoothed less and less. It begins
     * where all points stick or, if they are too many for that, at @p start, and smooths over what
     * the largest force moves.
     */
    ContactIterate continuation(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                                const ComplementarityConstants &constants,
                                const ContactState &start)
    {
      const bool from_sticking = can_stick_everywhere(problem);
      ContactIterate smooth;
      if (from_sticking)
        smooth = stick_everywhere(problem, bound_of, constants);
      else
        smooth.state = start;
      unsigned int n_problems = smooth.n_iterations;
      double smoothing        = 0.;
      for (const PointVector &force : smooth.state.force)
        smoothing = std::max(smoothing, (from_sticking ? tangential_norm(force) : force.norm()) /
                                            constants.tangential);
      for (unsigned int i = 0;; ++i)
      {
        ContactIterate exact =
            newton(problem, bound_of, constants, smooth.state, most_from_smoothed);
        n_problems += exact.n_iterations;
        if (exact.certified() || i == n_smoothings || smoothing == 0.)
        {
          exact.n_iterations = n_problems;
          return exact;
        }
        smooth = smoothed_newton(problem, bound_of, constants, smooth.state, smoothing,
                                 most_from_smoothed);
        n_problems += smooth.n_iterations;
        smoothing /= 6.;
      }
    }

    std::vector<PointStatus> status_of(const ContactIterate &iterate,
                                       const FrictionBoundOf &bound_of)
    {
      std::vector<PointStatus> status;
      for (unsigned int i = 0; i < iterate.state.force.size(); ++i)
      {
        const double p        = iterate.state.force[i][0],
                     friction = tangential_norm(iterate.state.force[i]),
                     slip     = tangential_norm(iterate.motion[i]);
        status.push_back(p <= 0.                                               ? PointStatus::open
                         : friction < (1. - 1e-9) * bound_of(i, p, slip).value ? PointStatus::stick
                                                                               : PointStatus::slip);
      }
      return status;
    }
  } // namespace

  ContactSolution solve_contact(const ContactProblem &problem, const PointFriction &friction,
                                const ComplementarityConstants &constants,
                                const ContactState &start)
  {
    const FrictionBoundOf bound_of =
        [&](const unsigned int point, const double pressure_force, const double slip)
    {
      const FrictionCoefficient mu = friction(point, slip);
      return FrictionBound{mu.value * pressure_force, mu.value, mu.derivative * pressure_force};
    };
    std::ostringstream tried;
    unsigned int n_iterations = 0;
    const auto solved         = [&](const ContactIterate &iterate, const std::string &what)
    {
      n_iterations += iterate.n_iterations;
      if (iterate.certified())
        return true;
      tried << (tried.str().empty() ? "" : ", ") << what << " (";
      if (iterate.failed)
        tried << "singular, or too many points touched,";
      else
        tried << iterate.certificate.worst();
      tried << " after " << iterate.n_iterations << ")";
      return false;
    };
    const auto solution = [&](const ContactIterate &iterate)
    {
      return ContactSolution{iterate.state,       iterate.motion, status_of(iterate, bound_of),
                             iterate.certificate, n_iterations,   tried.str()};
    };

    const ContactIterate first = newton(problem, bound_of, constants, start, most_newton);
    if (solved(first, "Newton's method"))
      return solution(first);
    // Too small a normal constant and too large a tangential one hurt least.
    const ComplementarityConstants other{constants.normal / 16., constants.tangential * 16.};
    const ContactIterate second = newton(problem, bound_of, other, start, most_newton);
    if (solved(second, "the same with constants of " + std::to_string(other.normal) + " and " +
                           std::to_string(other.tangential) + " N/m"))
      return solution(second);
    const ContactIterate third = continuation(problem, bound_of, constants, start);
    if (solved(third, "Newton's method from states of smoothed friction"))
      return solution(third);
    throw ComputationError("the contact problem of " + std::to_string(problem.n_points()) +
                           " points was not solved; tried, with the largest violation of the laws "
                           "of contact and the linear problems solved: " +
                           tried.str());
  }

  ContactSolution solve_without_friction(const ContactProblem &problem,
                                         const ComplementarityConstants &constants,
                                         const ContactState &start)
  {
    return solve_contact(
        problem, [](const unsigned int, const double) { return FrictionCoefficient{}; }, constants,
        start);
  }
} // namespace ringmotor
