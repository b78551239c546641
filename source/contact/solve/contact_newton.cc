// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/solve/contact_newton.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ringmotor
{
  namespace
  {
    /** A state and its relative motion. */
    struct Place
    {
      ContactState state;
      std::vector<PointVector> motion;
    };

    /** The motion depends linearly on the state, so both are interpolated by the same share. */
    Place between(const Place &from, const Place &to, const double share)
    {
      Place place = from;
      for (unsigned int i = 0; i < place.motion.size(); ++i)
      {
        place.state.force[i] += share * (to.state.force[i] - from.state.force[i]);
        place.motion[i] += share * (to.motion[i] - from.motion[i]);
      }
      for (unsigned int r = 0; r < place.state.rigid.size(); ++r)
        place.state.rigid[r] += share * (to.state.rigid[r] - from.state.rigid[r]);
      return place;
    }

    /** The equations that Newton's method solves. */
    class Equations
    {
    public:
      Equations(const FrictionBoundOf &bound_of, const ComplementarityConstants &constants)
          : bound_of(bound_of), constants(constants)
      {
      }

      /** How far (N) they are from being fulfilled. */
      double residual(const Place &place) const
      {
        double sum = 0.;
        for (unsigned int i = 0; i < place.motion.size(); ++i)
        {
          const PointVector &force = place.state.force[i], &motion = place.motion[i];
          const double pressed = std::max(0., force[0] - constants.normal * motion[0]),
                       bound =
                           pressed > 0. ? bound_of(i, pressed, tangential_norm(motion)).value : 0.;
          sum += std::pow(force[0] - pressed, 2) +
                 std::pow(friction_defect(force, motion, constants.tangential, bound), 2);
        }
        return std::sqrt(sum);
      }

      /** Goes to @p to, or half, a quarter, ... of the way if only that gives a residual not larger
       * than @p begin, the one at @p from; still the whole way if none does, as at a kink. @return
       * the residual */
      double search(const Place &from, const double begin, Place &to) const
      {
        constexpr double shortest = 1. / 64.;
        const double of_whole     = residual(to);
        if (of_whole <= begin)
          return of_whole;
        for (double share = 0.5; share >= shortest; share *= 0.5)
        {
          Place place       = between(from, to, share);
          const double left = residual(place);
          if (left <= begin)
          {
            to = std::move(place);
            return left;
          }
        }
        return of_whole;
      }

    private:
      const FrictionBoundOf &bound_of;
      const ComplementarityConstants &constants;
    };

    /** The tolerance of the next linear system: the square of the reduction of the residual in the
     * last step, which preserves quadratic convergence (Eisenstat and Walker 1996). */
    class Forcing
    {
    public:
      double reduction() const { return value; }

      /** From the residuals before and after a step. */
      void update(const double before, const double after)
      {
        const double gain = std::isfinite(before) && before > 0. ? after / before : 1.;
        value             = std::clamp(0.9 * gain * gain, finest, coarsest);
      }

    private:
      static constexpr double coarsest = 1e-3, finest = 1e-8;
      double value = coarsest;
    };
  } // namespace

  ContactIterate newton(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                        const ComplementarityConstants &constants, const ContactState &start,
                        const NewtonLimits &limits, RowSolver &solver,
                        const std::vector<PointVector> &seen)
  {
    const Equations equations(bound_of, constants);
    ContactIterate iterate;
    Place place{start, problem.relative_motion(start)};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // The motion seen belongs to another state; any result of the first step is an improvement.
    double left          = seen.empty() ? equations.residual(place) : infinity;
    double smallest      = infinity;
    unsigned int of_gain = 0; // iteration of the last gain
    Forcing forcing;
    while (iterate.n_iterations < limits.most_iterations)
    {
      const bool is_given = iterate.n_iterations == 0 && !seen.empty();
      const Place from    = place;
      const NewtonSystem system(problem, bound_of, constants, is_given ? seen : from.motion,
                                place.state, place.motion);
      ++iterate.n_iterations;
      iterate.failed = true;
      if (system.n_touching() > limits.most_touching ||
          !system.solve(solver, forcing.reduction(), place.state))
        break;
      iterate.failed      = false;
      place.motion        = problem.relative_motion(place.state);
      const double before = left;
      left                = equations.search(from, left, place);
      forcing.update(before, left);
      iterate.certificate = certify(problem, bound_of, place.state, place.motion);
      const double worst  = iterate.certificate.worst();
      const bool gains    = left < smallest;
      // Certified and no longer improving: only rounding is left.
      if (worst <= limits.converged || (iterate.certificate.holds() && !gains) ||
          (!gains && iterate.n_iterations >= of_gain + limits.most_without_gain))
        break;
      if (gains)
      {
        smallest = left;
        of_gain  = iterate.n_iterations;
      }
    }
    iterate.state  = std::move(place.state);
    iterate.motion = std::move(place.motion);
    return iterate;
  }
} // namespace ringmotor
