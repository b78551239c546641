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
    constexpr NewtonLimits finishing{12}, of_proximal{12, 1e-3};

    unsigned int n_pressed(const ContactState &state)
    {
      return std::count_if(state.force.begin(), state.force.end(),
                           [](const PointVector &force) { return force[0] > 0.; });
    }

    /** What elastic nodes would hold the rigid motions with, if only their own compliance gave way:
     * a scale for the springs of these motions. */
    class RigidStiffness
    {
    public:
      RigidStiffness(const ContactProblem &problem, const ComplementarityConstants &constants)
      {
        std::vector<unsigned int> all(problem.n_points());
        std::iota(all.begin(), all.end(), 0u);
        dealii::FullMatrix<double> balance;
        if (problem.n_rigid() > 0)
          problem.balance_derivatives(all, balance);
        for (unsigned int r = 0; r < problem.n_rigid(); ++r)
        {
          ContactState unit{std::vector<PointVector>(all.size()),
                            std::vector<double>(problem.n_rigid())};
          unit.rigid[r]                         = 1.;
          const std::vector<PointVector> motion = problem.motion_by(unit);
          of_node.emplace_back(all.size());
          for (const unsigned int i : all)
            for (unsigned int c = 0; c < 3; ++c)
              of_node[r][i] += (c == 0 ? constants.normal : constants.tangential) *
                               balance(r, 3 * i + c) * motion[i][c];
        }
      }

      /** By the nodes that touch, or by the stiffest one if that is more. */
      std::vector<double> against(const ContactState &state) const
      {
        std::vector<double> stiffness; // of each motion's own sign
        for (const std::vector<double> &of_motion : of_node)
        {
          double of_touching = 0., largest = 0.;
          for (unsigned int i = 0; i < of_motion.size(); ++i)
          {
            if (std::abs(of_motion[i]) > std::abs(largest))
              largest = of_motion[i];
            if (state.force[i][0] > 0.)
              of_touching += of_motion[i];
          }
          stiffness.push_back(std::abs(largest) > std::abs(of_touching) ? largest : of_touching);
        }
        return stiffness;
      }

    private:
      std::vector<std::vector<double>> of_node; ///< by rigid motion
    };

    /**
     * The proximal point algorithm: a chain of problems with springs, each of which begins where
     * the one before ended; where Newton's method fails the springs are made stronger, where it
     * succeeds weaker. When the laws are nearly fulfilled, Newton's method finishes without them.
     */
    ContactIterate proximal_points(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                                   const ComplementarityConstants &constants,
                                   const ContactState &start, RowSolver &solver)
    {
      constexpr unsigned int most_steps = 80;
      constexpr double weakest = 1e-8, strongest = 1e5, nearly = 0.05, fulfilled = 1e-10;
      const RigidStiffness rigid_stiffness(problem, constants);
      unsigned int n_systems = 0;
      const auto judged      = [&](const ContactState &state)
      {
        ContactIterate iterate;
        iterate.state        = state;
        iterate.motion       = problem.relative_motion(state);
        iterate.certificate  = certify(problem, bound_of, state, iterate.motion);
        iterate.n_iterations = n_systems;
        iterate.failed       = false;
        return iterate;
      };
      ContactIterate found = judged(start);
      // Of the springs, compared with the bodies themselves.
      double strength = n_pressed(start) > 0 ? 1. / 16. : 1.;
      for (unsigned int step = 0; step < most_steps && strength < strongest; ++step)
      {
        ProximalProblem::Springs springs{strength / constants.normal,
                                         strength / constants.tangential,
                                         rigid_stiffness.against(found.state)};
        for (double &stiffness : springs.rigid_stiffness)
          stiffness *= strength;
        const ProximalProblem proximal(problem, found.state, springs);
        const ComplementarityConstants softer{constants.normal / (1. + strength),
                                              constants.tangential / (1. + strength)};
        RowSolver of_springs; // whose systems are others
        const ContactIterate next =
            newton(proximal, bound_of, softer, found.state, of_proximal, of_springs);
        found.n_iterations = n_systems += next.n_iterations;
        if (next.failed || !(next.certificate.worst() <= of_proximal.converged))
        {
          strength *= 8.;
          continue;
        }
        found = judged(next.state);
        strength /= 16.;
        if (found.certificate.worst() > nearly && strength > weakest)
          continue;
        ContactIterate exact = newton(problem, bound_of, constants, found.state, finishing, solver);
        exact.n_iterations = found.n_iterations = n_systems += exact.n_iterations;
        if (exact.certified())
          return exact;
        // The springs' forces vanish as the chain converges, so its limit solves the problem
        // itself, also where that has more solutions than one and Newton's systems are singular.
        if (found.certificate.worst() <= fulfilled)
          return found;
      }
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
                                const ContactState &start, const std::vector<PointVector> &seen,
                                RowSolver &solver)
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
        tried << "given up";
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

    const ContactState begin = is_finite(start) ? start : nothing(problem);
    // Without forces Newton's first steps let far too many nodes touch; springs hold them back.
    if (const unsigned int n = n_pressed(begin); n > 0)
    {
      NewtonLimits alone{40};
      alone.most_touching        = 2 * n + 20;
      const ContactIterate first = newton(problem, bound_of, constants, begin, alone, solver, seen);
      if (solved(first, "Newton's method"))
        return solution(first);
    }
    const ContactIterate second = proximal_points(problem, bound_of, constants, begin, solver);
    if (solved(second, "the proximal point algorithm"))
      return solution(second);
    throw ComputationError("the contact problem of " + std::to_string(problem.n_points()) +
                           " points was not solved; tried, with the largest violation of the laws "
                           "of contact and the linear problems solved: " +
                           tried.str());
  }

  ContactSolution solve_contact(const ContactProblem &problem, const PointFriction &friction,
                                const ComplementarityConstants &constants,
                                const ContactState &start)
  {
    RowSolver solver;
    return solve_contact(problem, friction, constants, start, {}, solver);
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
