// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/contact_newton.h>
#include <ringmotor/contact/solve_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Tangential = Tensor<1, 2>;

    Tangential tangential(const PointVector &vector)
    {
      Tangential part;
      part[0] = vector[1];
      part[1] = vector[2];
      return part;
    }

    constexpr double converged          = 1e-10; ///< of certificates
    constexpr double smoothed_converged = 1e-3;  ///< of changes of forces

    constexpr unsigned int affordable = 1000; ///< points with friction, whatever the start

    /** A start touches at about as many points as the solution does. Where many more rub,
     * iterates are lost, and their dense matrices would cost minutes and gigabytes. */
    unsigned int most_rubbing(const ContactProblem &problem, const ContactState &start)
    {
      const unsigned int n_pressed =
          std::count_if(start.force.begin(), start.force.end(),
                        [](const PointVector &force) { return force[0] > 0.; });
      return can_stick_everywhere(problem) || n_pressed == 0 ? problem.n_points()
                                                             : std::max(300u, 3 * n_pressed);
    }

    /** One linear problem of Newton's method. */
    class LinearStep
    {
    public:
      /** @param smoothing m, zero for the laws themselves
       *  @param most_rubbing points with friction; steps with more fail */
      LinearStep(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                 const ComplementarityConstants &constants, const double smoothing,
                 const unsigned int most_rubbing)
          : problem(problem), bound_of(bound_of), constants(constants), smoothing(smoothing),
            most_rubbing(most_rubbing)
      {
      }

      /** Replaces @p iterate by the next one, unless the problem is singular. */
      void take(ContactIterate &iterate)
      {
        choose_status(iterate);
        const unsigned int n_rubbing =
            std::count_if(friction.begin(), friction.end(),
                          [](const Friction &friction) { return !friction.stays_zero; });
        if (n_rubbing > most_rubbing)
          iterate.failed = true;
        else
          solve(iterate);
      }

      /** Replaces @p iterate by the state in which all points stick, if there is one. */
      void stick_everywhere(ContactIterate &iterate)
      {
        touching.resize(problem.n_points());
        std::iota(touching.begin(), touching.end(), 0u);
        friction.assign(touching.size(), Friction());
        iterate.state  = {std::vector<PointVector>(problem.n_points()),
                          std::vector<double>(problem.n_rigid())};
        iterate.motion = problem.relative_motion(iterate.state);
        iterate.failed = false;
        solve(iterate);
      }

      /** The largest change of a force in the last step, against the largest such force. */
      double change() const { return largest_change; }

    private:
      enum class Law
      {
        stick,
        slip,
        smoothed
      };

      struct Friction
      {
        Law law = Law::stick;
        FrictionBound bound;
        Tangential direction;    ///< tau / |tau|
        double ratio    = 1.;    ///< bound / |tau|
        bool stays_zero = false; ///< no friction now, none before
      };

      /** Opens and closes points, lets them stick or slip; open points lose their forces. */
      void choose_status(ContactIterate &iterate)
      {
        touching.clear();
        friction.clear();
        bool lost_force = false;
        for (unsigned int i = 0; i < iterate.state.force.size(); ++i)
        {
          PointVector &force       = iterate.state.force[i];
          const PointVector &moved = iterate.motion[i];
          const double reach       = force[0] - constants.normal * moved[0];
          if (reach <= 0.)
          {
            lost_force = lost_force || force != PointVector();
            force      = 0.;
            continue;
          }
          touching.push_back(i);
          friction.push_back(friction_of(i, reach, force, moved));
        }
        if (lost_force)
          iterate.motion = problem.relative_motion(iterate.state);
      }

      Friction friction_of(const unsigned int i, const double reach, const PointVector &force,
                           const PointVector &moved) const
      {
        const Tangential slip = tangential(moved);
        Friction law;
        if (smoothing > 0.)
        {
          law.law   = Law::smoothed;
          law.bound = bound_of(i, std::max(0., force[0]), slip.norm());
          return law;
        }
        const Tangential tau = tangential(force) - constants.tangential * slip;
        const double size    = tau.norm();
        law.bound            = bound_of(i, reach, slip.norm());
        if (size <= law.bound.value && law.bound.value > 0.)
          return law;
        law.law   = Law::slip;
        law.ratio = 0.;
        law.stays_zero =
            tangential(force).norm() == 0. && law.bound.value == 0. && law.bound.by_pressure == 0.;
        if (size > 0.)
        {
          law.direction = tau / size;
          law.ratio     = law.bound.value / size;
        }
        return law;
      }

      void solve(ContactIterate &iterate)
      {
        ++iterate.n_iterations;
        problem.derivatives(touching, derivatives);
        assemble(iterate);
        iterate.failed = !solve_linear();
        if (iterate.failed)
          return;
        const unsigned int n_touching = touching.size();
        std::array<double, 2> force{}, change{}; // normal and tangential
        for (unsigned int row = 0; row < 3 * n_touching; ++row)
        {
          double &updated                  = iterate.state.force[touching[row / 3]][row % 3];
          const unsigned int is_tangential = row % 3 > 0;
          updated += right_hand_side[row];
          force[is_tangential]  = std::max(force[is_tangential], std::abs(updated));
          change[is_tangential] = std::max(change[is_tangential], std::abs(right_hand_side[row]));
        }
        largest_change = 0.;
        for (const unsigned int is_tangential : {0u, 1u})
          if (force[is_tangential] > 0.)
            largest_change = std::max(largest_change, change[is_tangential] / force[is_tangential]);
        for (unsigned int r = 0; r < problem.n_rigid(); ++r)
          iterate.state.rigid[r] += right_hand_side[3 * n_touching + r];
        iterate.motion = problem.relative_motion(iterate.state);
      }

      bool solve_linear()
      {
        // Forces that are zero and stay zero, as all friction of surfaces without it, are no
        // unknowns.
        std::vector<types::global_dof_index> unknowns;
        for (unsigned int row = 0; row < size; ++row)
          if (row >= 3 * touching.size() || row % 3 == 0 || !friction[row / 3].stays_zero)
            unknowns.push_back(row);
        if (unknowns.empty()) // LAPACK does not take empty matrices
          return true;
        Vector<double> solution(unknowns.size());
        FullMatrix<double> part;
        const bool is_part = unknowns.size() < size;
        if (is_part)
        {
          part.reinit(unknowns.size(), unknowns.size());
          part.extract_submatrix_from(matrix, unknowns, unknowns);
        }
        for (unsigned int i = 0; i < unknowns.size(); ++i)
          solution[i] = right_hand_side[unknowns[i]];
        if (!solve_matrix(is_part ? part : matrix, solution))
          return false;
        right_hand_side = 0.;
        for (unsigned int i = 0; i < unknowns.size(); ++i)
          right_hand_side[unknowns[i]] = solution[i];
        return std::isfinite(right_hand_side.l1_norm());
      }

      void assemble(const ContactIterate &iterate)
      {
        const unsigned int n_touching = touching.size(), n_rigid = problem.n_rigid();
        size = 3 * n_touching + n_rigid;
        matrix.reinit(size, size);
        right_hand_side.reinit(size);
        for (unsigned int a = 0; a < n_touching; ++a)
        {
          const PointVector &force = iterate.state.force[touching[a]];
          const PointVector &moved = iterate.motion[touching[a]];
          // Rows in N: forces and scaled motions are of one size.
          add_motions(3 * a, 3 * a, constants.normal);
          right_hand_side[3 * a] = -constants.normal * moved[0];
          switch (friction[a].law)
          {
          case Law::stick:
            add_stick(a, moved);
            break;
          case Law::slip:
            add_slip(a, force, moved);
            break;
          case Law::smoothed:
            add_smoothed(a, force, moved);
            break;
          }
        }
        problem.balance_derivatives(touching, derivatives);
        const std::vector<double> balances = problem.balances(iterate.state);
        for (unsigned int r = 0; r < n_rigid; ++r)
        {
          for (unsigned int column = 0; column < size; ++column)
            matrix(3 * n_touching + r, column) = derivatives(r, column);
          right_hand_side[3 * n_touching + r] = -balances[r];
        }
      }

      /** Adds a multiple of the derivatives of a motion. */
      void add_motions(const unsigned int row, const unsigned int motion, const double factor)
      {
        for (unsigned int column = 0; column < size; ++column)
          matrix(row, column) += factor * derivatives(motion, column);
      }

      void add_stick(const unsigned int a, const PointVector &moved)
      {
        for (unsigned int c = 1; c < 3; ++c)
        {
          add_motions(3 * a + c, 3 * a + c, constants.tangential);
          right_hand_side[3 * a + c] = -constants.tangential * moved[c];
        }
      }

      /** Newton's linearisation of F_t = bound(p, |slip|) tau/|tau|. */
      void add_slip(const unsigned int a, const PointVector &force, const PointVector &moved)
      {
        const Friction &law       = friction[a];
        const Tangential slip     = tangential(moved);
        const double slip_size    = slip.norm();
        const FrictionBound bound = bound_of(touching[a], force[0], slip_size);
        // Where F_t is not yet at the bound, its direction would leave motions along it free
        // (Hueeber, Stadler and Wohlmuth 2008); the limit is the same.
        Tangential direction = tangential(force);
        if (direction.norm() > 0.)
          direction /= std::max(law.bound.value, direction.norm());
        for (unsigned int c = 0; c < 2; ++c)
        {
          const unsigned int row = 3 * a + 1 + c;
          for (unsigned int d = 0; d < 2; ++d)
          {
            // d(tau/|tau|) = (1 - e e^T) d tau / |tau|, d tau = dF_t - c_t d slip, one e of F_t
            const double turn = law.ratio * ((c == d) - direction[c] * law.direction[d]);
            double by_slip    = constants.tangential * turn;
            if (slip_size > 0.)
              by_slip -= law.direction[c] * bound.by_slip * slip[d] / slip_size;
            add_motions(row, 3 * a + 1 + d, by_slip);
            matrix(row, 3 * a + 1 + d) -= turn;
          }
          matrix(row, row) += 1.;
          matrix(row, 3 * a) -= law.direction[c] * bound.by_pressure;
          right_hand_side[row] = bound.value * law.direction[c] - force[1 + c];
        }
      }

      /** Linearisation of length F_t + bound slip = 0, length^2 = |slip|^2 + smoothing^2. */
      void add_smoothed(const unsigned int a, const PointVector &force, const PointVector &moved)
      {
        const FrictionBound &bound = friction[a].bound;
        const Tangential slip      = tangential(moved);
        const double length        = std::sqrt(slip.norm_square() + smoothing * smoothing);
        Tangential within          = tangential(force);
        if (within.norm() > bound.value)
          within *= bound.value / within.norm();
        for (unsigned int c = 0; c < 2; ++c)
        {
          const unsigned int row = 3 * a + 1 + c;
          for (unsigned int d = 0; d < 2; ++d)
            add_motions(row, 3 * a + 1 + d,
                        (within[c] * slip[d] / length + (c == d) * bound.value) / length);
          matrix(row, row) += 1.;
          matrix(row, 3 * a) += bound.by_pressure * slip[c] / length;
          right_hand_side[row] = -bound.value * slip[c] / length - force[1 + c];
        }
      }

      const ContactProblem &problem;
      const FrictionBoundOf &bound_of;
      const ComplementarityConstants constants;
      const double smoothing;
      const unsigned int most_rubbing;
      std::vector<unsigned int> touching; ///< the points that touch in this step
      std::vector<Friction> friction;     ///< for each of them
      unsigned int size     = 0;
      double largest_change = 0.;
      FullMatrix<double> derivatives;
      FullMatrix<double> matrix;
      Vector<double> right_hand_side;
    };

    /** Steps until @p ended says so. */
    template <typename Ended>
    ContactIterate iterate(const ContactProblem &problem, LinearStep &step,
                           const ContactState &start, const unsigned int most_iterations,
                           const Ended &ended)
    {
      ContactIterate iterate;
      iterate.state               = start;
      iterate.motion              = problem.relative_motion(start);
      iterate.certificate.balance = std::numeric_limits<double>::infinity();
      bool may_stick              = can_stick_everywhere(problem);
      do
      {
        step.take(iterate);
        if (iterate.failed && may_stick)
        {
          step.stick_everywhere(iterate);
          may_stick = false;
        }
      } while (!iterate.failed && !ended(iterate) && iterate.n_iterations < most_iterations);
      return iterate;
    }
  } // namespace

  bool can_stick_everywhere(const ContactProblem &problem)
  {
    return problem.n_points() <= affordable;
  }

  ContactIterate newton(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                        const ComplementarityConstants &constants, const ContactState &start,
                        const unsigned int most_iterations)
  {
    LinearStep step(problem, bound_of, constants, 0., most_rubbing(problem, start));
    return iterate(problem, step, start, most_iterations,
                   [&](ContactIterate &iterate)
                   {
                     const double before = iterate.certificate.worst();
                     iterate.certificate =
                         certify(problem, bound_of, iterate.state, iterate.motion);
                     const double worst = iterate.certificate.worst();
                     // No better than before: rounding is all that is left.
                     return worst <= converged || (iterate.certificate.holds() && worst >= before);
                   });
  }

  ContactIterate smoothed_newton(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                                 const ComplementarityConstants &constants,
                                 const ContactState &start, const double smoothing,
                                 const unsigned int most_iterations)
  {
    LinearStep step(problem, bound_of, constants, smoothing, most_rubbing(problem, start));
    return iterate(problem, step, start, most_iterations,
                   [&](const ContactIterate &) { return step.change() <= smoothed_converged; });
  }

  ContactIterate stick_everywhere(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                                  const ComplementarityConstants &constants)
  {
    LinearStep step(problem, bound_of, constants, 0., problem.n_points());
    ContactIterate iterate;
    step.stick_everywhere(iterate);
    return iterate;
  }
} // namespace ringmotor
