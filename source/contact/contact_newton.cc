// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/contact_newton.h>

#include <limits>

namespace ringmotor
{
  namespace
  {
    /** How far (N) the equations are from being fulfilled that Newton's method solves. */
    double residual(const FrictionBoundOf &bound_of, const ComplementarityConstants &constants,
                    const ContactState &state, const std::vector<PointVector> &motion)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < motion.size(); ++i)
      {
        const double pressed = std::max(0., state.force[i][0] - constants.normal * motion[i][0]),
                     bound =
                         pressed > 0. ? bound_of(i, pressed, tangential_norm(motion[i])).value : 0.;
        sum += std::pow(state.force[i][0] - pressed, 2) +
               std::pow(friction_defect(state.force[i], motion[i], constants.tangential, bound), 2);
      }
      return std::sqrt(sum);
    }
  } // namespace

  ContactIterate newton(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                        const ComplementarityConstants &constants, const ContactState &start,
                        const NewtonLimits &limits, RowSolver &solver,
                        const std::vector<PointVector> &seen)
  {
    ContactIterate iterate;
    iterate.state        = start;
    iterate.motion       = problem.relative_motion(start);
    double smallest      = std::numeric_limits<double>::infinity();
    unsigned int of_gain = 0; // iteration of the last gain
    while (iterate.n_iterations < limits.most_iterations)
    {
      const bool is_first                       = iterate.n_iterations == 0 && !seen.empty();
      const std::vector<PointVector> &chosen_by = is_first ? seen : iterate.motion;
      const NewtonSystem system(problem, bound_of, constants, chosen_by, iterate.state,
                                iterate.motion);
      ++iterate.n_iterations;
      iterate.failed = true;
      if (system.n_touching() > limits.most_touching || !system.solve(solver, iterate.state))
        break;
      iterate.failed      = false;
      iterate.motion      = problem.relative_motion(iterate.state);
      iterate.certificate = certify(problem, bound_of, iterate.state, iterate.motion);
      const double worst  = iterate.certificate.worst();
      const double left   = residual(bound_of, constants, iterate.state, iterate.motion);
      const bool gains    = left < smallest;
      // Without a gain below the limit of certificates rounding is all that is left.
      if (worst <= limits.converged || (iterate.certificate.holds() && !gains) ||
          (!gains && iterate.n_iterations >= of_gain + limits.most_without_gain))
        break;
      if (gains)
      {
        smallest = left;
        of_gain  = iterate.n_iterations;
      }
    }
    return iterate;
  }
} // namespace ringmotor
