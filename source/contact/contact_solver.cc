// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/contact_solver.h>
#include <ringmotor/contact/proximal_problem.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    constexpr NewtonLimits alone{40}, finishing{12}, of_proximal{12, 1e-3};

    /** Springs as strong as the bodies themselves, times @p strength. Those of a rigid motion are
     * measured by what it does at the nodes that touch. */
    ProximalProblem::Springs springs_of(const ContactProblem &problem,
                                        const ComplementarityConstants &constants,
                                        const ContactState &state, const double strength)
    {
      ProximalProblem::Springs springs{strength / constants.normal, strength / constants.tangential,
                                       std::vector<double>(problem.n_rigid(), 0.)};
      std::vector<unsigned int> all(problem.n_points());
      std::iota(all.begin(), all.end(), 0u);
      dealii::FullMatrix<double> balance;
      if (problem.n_rigid() > 0)
        problem.balance_derivatives(all, balance);
      for (unsigned int r = 0; r < problem.n_rigid(); ++r)
      {
        ContactState unit{std::vector<PointVector>(problem.n_points()),
                          std::vector<double>(problem.n_rigid())};
        unit.rigid[r]                         = 1.;
        const std::vector<PointVector> motion = problem.motion_by(unit);
        double of_touching = 0., of_node = 0.; // of a rigid motion's own sign
        for (const unsigned int i : all)
        {
          double stiffness = 0.;
          for (unsigned int c = 0; c < 3; ++c)
            stiffness += (c == 0 ? constants.normal : constants.tangential) *
                         balance(r, 3 * i + c) * motion[i][c];
          if (std::abs(stiffness) > std::abs(of_node))
            of_node = stiffness;
          if (state.force[i][0] > 0.)
            of_touching += stiffness;
        }
        springs.rigid_stiffness[r] =
            strength * (std::abs(of_node) > std::abs(of_touching) ? of_node : of_touching);
      }
      return springs;
    }

    /**
     * The proximal point algorithm: a chain of problems with springs, each of which begins where
     * the one before ended; where Newton's method fails the springs are made stronger, where it
     * succeeds weaker. When the laws are nearly fulfilled, Newton's method finishes without them.
     */
    ContactIterate proximal_points(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                                   const ComplementarityConstants &constants,
                                   const ContactState &start)
    {
      constexpr unsigned int most_steps = 80;
      constexpr double weakest = 1e-8, strongest = 1e5, nearly = 0.05, fulfilled = 1e-10;
      ContactIterate found;
      found.state             = start;
      unsigned int n_problems = 0;
      double strength         = 1.;
      for (unsigned int step = 0; step < most_steps && strength < strongest; ++step)
      {
        const ContactState centre              = found.state;
        const ProximalProblem::Springs springs = springs_of(problem, constants, centre, strength);
        const ProximalProblem proximal(problem, centre, springs);
        const ComplementarityConstants softer{constants.normal / (1. + strength),
                                              constants.tangential / (1. + strength)};
        const ContactIterate next = newton(proximal, bound_of, softer, centre, of_proximal);
        n_problems += next.n_iterations;
        if (next.failed || !(next.certificate.worst() <= of_proximal.converged))
        {
          strength *= 8.;
          continue;
        }
        found.state = next.state;
        strength /= 6.;
        const double distance =
            certify(problem, bound_of, found.state, problem.relative_motion(found.state)).worst();
        if (distance > nearly && strength > weakest)
          continue;
        ContactIterate exact = newton(problem, bound_of, constants, found.state, finishing);
        n_problems += exact.n_iterations;
        exact.n_iterations = n_problems;
        if (exact.certified())
          return exact;
        // The springs' forces vanish as the chain converges, so its limit solves the problem
        // itself, also where that has more solutions than one and Newton's systems are singular.
        if (distance <= fulfilled)
        {
          found.motion       = problem.relative_motion(found.state);
          found.certificate  = certify(problem, bound_of, found.state, found.motion);
          found.n_iterations = n_problems;
          return found;
        }
      }
      found.motion       = problem.relative_motion(found.state);
      found.certificate  = certify(problem, bound_of, found.state, found.motion);
      found.n_iterations = n_problems;
      // A state that the chain did not confirm is none, even if it fulfils the laws.
      found.failed = found.certificate.holds();
      return found;
    }

    ContactState nothing(const ContactProblem &problem)
    {
      return {std::vector<PointVector>(problem.n_points()), std::vector<double>(problem.n_rigid())};
    }

    bool is_finite(const ContactState &state)
    {
      return std::all_of(state.force.begin(), state.force.end(),
                         [](const PointVector &force) { return std::isfinite(force.norm()); }) &&
             std::all_of(state.rigid.begin(), state.rigid.end(),
                         [](const double motion) { return std::isfinite(motion); });
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
        tried << "a linear system was singular";
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

    const ContactState begin   = is_finite(start) ? start : nothing(problem);
    const ContactIterate first = newton(problem, bound_of, constants, begin, alone);
    if (solved(first, "Newton's method"))
      return solution(first);
    const ContactIterate second = proximal_points(problem, bound_of, constants, begin);
    if (solved(second, "the proximal point algorithm"))
      return solution(second);
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
