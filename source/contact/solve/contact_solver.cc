// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/solve/contact_solver.h>
#include <ringmotor/contact/solve/given_coefficients.h>
#include <ringmotor/contact/solve/proximal_points.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ringmotor
{
  namespace
  {
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

    /** Looks for the solution of one problem in several ways, and remembers what was tried. */
    class Search
    {
    public:
      Search(const ContactProblem &problem, const ComplementarityConstants &constants,
             RowSolver &solver, const Fallback fallback)
          : problem(problem), constants(constants), solver(solver), fallback(fallback)
      {
      }

      /** By Newton's method; by proximal points, if it fails or the start has no forces. @p enough
       * is the largest violation of the laws that suffices for one of a chain of problems. */
      bool solve(const FrictionBoundOf &bound_of, const ContactState &start,
                 const std::vector<PointVector> &seen,
                 const double enough = NewtonLimits().converged)
      {
        if (solve_alone(bound_of, start, seen, enough))
          return true;
        constexpr unsigned int many = 80, few = 12;
        const unsigned int most_points = fallback == Fallback::few_proximal_points ? few : many;
        return fallback != Fallback::none &&
               takes(proximal_points(problem, bound_of, constants, start, solver, most_points),
                     "the proximal point algorithm", enough);
      }

      /** By Newton's method alone. Without forces its first steps let far too many nodes touch. */
      bool solve_alone(const FrictionBoundOf &bound_of, const ContactState &start,
                       const std::vector<PointVector> &seen,
                       const double enough = NewtonLimits().converged)
      {
        const unsigned int n = start.n_pressed();
        NewtonLimits alone{30, enough}; // from a neighbouring state it takes some ten
        alone.most_touching = 2 * n + 20;
        return n > 0 && takes(newton(problem, bound_of, constants, start, alone, solver, seen),
                              "Newton's method", enough);
      }

      /**
       * For a coefficient that falls with the slip: a chain of problems in which each point has the
       * coefficient that belongs to its slip in the problem before, the static one at first.
       * Springs would only aggravate such laws, which the bodies' stiffness has to stabilise. The
       * chain moves away from a state in which a point could either stick or continue to slip, and
       * ends at a stable one.
       */
      bool solve_by_coefficients(const PointFriction &friction, const FrictionBoundOf &bound_of,
                                 const ContactState &start)
      {
        constexpr unsigned int most_rounds = 100;
        constexpr double settled = 1e-12, nearly = 1e-3, share = 1e-2; // of the coefficients
        GivenCoefficients coefficients(friction, problem.n_points());
        const FrictionBoundOf given = [&](const unsigned int i, const double pressed, const double)
        {
          return FrictionBound{coefficients[i] * pressed, coefficients[i], 0.};
        };
        double change = 1.;
        for (unsigned int round = 0; round < most_rounds; ++round)
        {
          const double enough = std::max(share * change, NewtonLimits().converged);
          if (!solve(given, round == 0 ? start : found.state, {}, enough))
            return false;
          change = coefficients.update(found.state, found.motion);
          if (change <= nearly && solve_alone(bound_of, found.state, {}))
            return true;
          if (change <= settled)
          {
            found.certificate = certify(problem, bound_of, found.state, found.motion);
            if (found.certified())
              return true;
          }
        }
        next_try() << "coefficients of the previous slip (they change by " << change << " after "
                   << most_rounds << " problems)";
        return false;
      }

      /** The state that was found last, and all systems that were solved. */
      const ContactIterate &result() const { return found; }
      unsigned int n_iterations() const { return n_systems; }
      std::string tried() const { return text.str(); }

    private:
      /** Where failed attempts are listed. */
      std::ostream &next_try() { return text << (text.str().empty() ? "" : ", "); }

      bool takes(const ContactIterate &iterate, const std::string &what, const double enough)
      {
        n_systems += iterate.n_iterations;
        if (iterate.certified() || (!iterate.failed && iterate.certificate.worst() <= enough))
        {
          found = iterate;
          return true;
        }
        next_try() << what << " (";
        if (iterate.failed)
          text << "given up";
        else
          text << iterate.certificate.worst();
        text << " after " << iterate.n_iterations << ")";
        return false;
      }

      const ContactProblem &problem;
      const ComplementarityConstants &constants;
      RowSolver &solver;
      const Fallback fallback;
      ContactIterate found;
      unsigned int n_systems = 0;
      std::ostringstream text;
    };
  } // namespace

  ContactSolution solve_contact(const ContactProblem &problem, const PointFriction &friction,
                                const ComplementarityConstants &constants,
                                const ContactState &start, const std::vector<PointVector> &seen,
                                RowSolver &solver, const Fallback fallback)
  {
    bool falls = false;
    for (unsigned int i = 0; i < problem.n_points(); ++i)
      falls = falls || friction(i, 0.).derivative < 0.;
    const FrictionBoundOf bound_of =
        [&](const unsigned int point, const double pressure_force, const double slip)
    {
      const FrictionCoefficient mu = friction(point, slip);
      return FrictionBound{mu.value * pressure_force, mu.value, mu.derivative * pressure_force};
    };
    const ContactState begin = is_finite(start) ? start : nothing(problem);
    Search search(problem, constants, solver, fallback);
    const bool is_solved = falls ? search.solve_alone(bound_of, begin, seen) ||
                                       search.solve_by_coefficients(friction, bound_of, begin)
                                 : search.solve(bound_of, begin, seen);
    if (!is_solved)
      throw ComputationError("the contact problem with " + std::to_string(problem.n_points()) +
                             " contact nodes did not converge; attempts, with the largest "
                             "violation of the contact laws after a number of linear solves: " +
                             search.tried());
    const ContactIterate &found = search.result();
    return {{found.state, found.motion, {}, 0., status_of(found, bound_of)},
            found.certificate,
            search.n_iterations(),
            search.tried()};
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
