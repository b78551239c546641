// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/contact_solver.h>
#include <ringmotor/parameters/errors.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

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

    /** What Newton's method left. */
    struct Iterate
    {
      ContactState state;
      std::vector<PointVector> motion;
      ContactCertificate certificate;
      unsigned int n_iterations = 0;
    };

    constexpr double converged         = 1e-10;
    constexpr unsigned int most_newton = 40;
    constexpr unsigned int most_tresca = 60;

    /** One linear problem of Newton's method. */
    class LinearStep
    {
    public:
      LinearStep(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                 const ComplementarityConstants &constants)
          : problem(problem), bound_of(bound_of), constants(constants)
      {
      }

      /** Replaces @p iterate by the next one. Returns false if the problem is singular. */
      bool take(Iterate &iterate)
      {
        choose_status(iterate);
        iterate.motion = problem.relative_motion(iterate.state);
        problem.derivatives(touching, derivatives);
        assemble(iterate);
        try
        {
          matrix.compute_lu_factorization();
          matrix.solve(right_hand_side);
        }
        catch (const LACExceptions::ExcSingular &)
        {
          return false;
        }
        const unsigned int n_touching = touching.size();
        for (unsigned int a = 0; a < n_touching; ++a)
          for (unsigned int c = 0; c < 3; ++c)
            iterate.state.force[touching[a]][c] += right_hand_side[3 * a + c];
        for (unsigned int r = 0; r < problem.n_rigid(); ++r)
          iterate.state.rigid[r] += right_hand_side[3 * n_touching + r];
        iterate.motion = problem.relative_motion(iterate.state);
        ++iterate.n_iterations;
        return true;
      }

    private:
      struct Friction
      {
        bool sticks;
        FrictionBound bound;
        Tangential direction; ///< tau / |tau|
        double ratio;         ///< bound / |tau|
      };

      /** Opens and closes points, lets them stick or slip; open points lose their forces. */
      void choose_status(Iterate &iterate)
      {
        touching.clear();
        friction.clear();
        for (unsigned int i = 0; i < iterate.state.force.size(); ++i)
        {
          PointVector &force       = iterate.state.force[i];
          const PointVector &moved = iterate.motion[i];
          const double reach       = force[0] - constants.normal * moved[0];
          if (reach <= 0.)
          {
            force = 0.;
            continue;
          }
          const Tangential slip     = tangential(moved);
          const Tangential tau      = tangential(force) - constants.tangential * slip;
          const FrictionBound bound = bound_of(i, reach, slip.norm());
          const double size         = tau.norm();
          touching.push_back(i);
          if (size <= bound.value && bound.value > 0.)
            friction.push_back({true, bound, {}, 1.});
          else if (size > 0.)
            friction.push_back({false, bound, tau / size, bound.value / size});
          else
            friction.push_back({false, bound, {}, 0.});
        }
      }

      void assemble(const Iterate &iterate)
      {
        const unsigned int n_touching = touching.size(), n_rigid = problem.n_rigid();
        size = 3 * n_touching + n_rigid;
        matrix.reinit(size);
        right_hand_side.reinit(size);
        for (unsigned int a = 0; a < n_touching; ++a)
        {
          const PointVector &motion = iterate.motion[touching[a]];
          // Rows in N: forces and scaled motions are of one size.
          for (unsigned int column = 0; column < size; ++column)
            matrix(3 * a, column) = constants.normal * derivatives(3 * a, column);
          right_hand_side[3 * a] = -constants.normal * motion[0];
          if (friction[a].sticks)
            add_stick(a, motion);
          else
            add_slip(a, iterate.state.force[touching[a]], motion);
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

      void add_stick(const unsigned int a, const PointVector &motion)
      {
        for (unsigned int c = 1; c < 3; ++c)
        {
          for (unsigned int column = 0; column < size; ++column)
            matrix(3 * a + c, column) = constants.tangential * derivatives(3 * a + c, column);
          right_hand_side[3 * a + c] = -constants.tangential * motion[c];
        }
      }

      /** Newton's linearisation of F_t = bound(p, |slip|) tau/|tau|. */
      void add_slip(const unsigned int a, const PointVector &force, const PointVector &motion)
      {
        const Friction &law       = friction[a];
        const Tangential slip     = tangential(motion);
        const double slip_size    = slip.norm();
        const FrictionBound bound = bound_of(touching[a], force[0], slip_size);
        for (unsigned int c = 0; c < 2; ++c)
        {
          const unsigned int row = 3 * a + 1 + c;
          // d(tau/|tau|) = (1 - e e^T) d tau / |tau|, d tau = dF_t - c_t d slip
          Tangential turn, of_slip;
          for (unsigned int d = 0; d < 2; ++d)
          {
            turn[d]    = law.ratio * ((c == d) - law.direction[c] * law.direction[d]);
            of_slip[d] = constants.tangential * turn[d];
            if (slip_size > 0.)
              of_slip[d] -= law.direction[c] * bound.by_slip * slip[d] / slip_size;
          }
          for (unsigned int column = 0; column < size; ++column)
            matrix(row, column) = of_slip[0] * derivatives(3 * a + 1, column) +
                                  of_slip[1] * derivatives(3 * a + 2, column);
          matrix(row, row) += 1.;
          matrix(row, 3 * a + 1) -= turn[0];
          matrix(row, 3 * a + 2) -= turn[1];
          matrix(row, 3 * a) -= law.direction[c] * bound.by_pressure;
          right_hand_side[row] = bound.value * law.direction[c] - force[1 + c];
        }
      }

      const ContactProblem &problem;
      const FrictionBoundOf &bound_of;
      const ComplementarityConstants constants;
      std::vector<unsigned int> touching; ///< the points that touch in this step
      std::vector<Friction> friction;     ///< for each of them
      unsigned int size = 0;
      FullMatrix<double> derivatives;
      LAPACKFullMatrix<double> matrix;
      Vector<double> right_hand_side;
    };

    /** Newton's method; its last iterate, whether it has converged or not. */
    Iterate newton(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                   const ComplementarityConstants &constants, const ContactState &start)
    {
      LinearStep step(problem, bound_of, constants);
      Iterate iterate{start, problem.relative_motion(start), {}, 0};
      do
      {
        if (!step.take(iterate))
        {
          iterate.certificate.balance = std::numeric_limits<double>::infinity();
          return iterate;
        }
        iterate.certificate = certify(problem, bound_of, iterate.state, iterate.motion);
      } while (!(iterate.certificate.worst() <= converged) && iterate.n_iterations < most_newton);
      return iterate;
    }

    /** A fixed point on the friction bounds: with given bounds the problem is convex. */
    Iterate tresca(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                   const ComplementarityConstants &constants, const ContactState &start)
    {
      Iterate iterate{start, problem.relative_motion(start), {}, 0};
      std::vector<double> given(problem.n_points());
      const FrictionBoundOf given_bound = [&](const unsigned int i, const double, const double) {
        return FrictionBound{given[i], 0., 0.};
      };
      for (unsigned int round = 0; round < most_tresca; ++round)
      {
        for (unsigned int i = 0; i < given.size(); ++i)
          given[i] = bound_of(i, std::max(0., iterate.state.force[i][0]),
                              tangential(iterate.motion[i]).norm())
                         .value;
        const unsigned int n_before = iterate.n_iterations;
        iterate                     = newton(problem, given_bound, constants, iterate.state);
        iterate.n_iterations += n_before;
        if (!(iterate.certificate.worst() <= ContactCertificate::limit))
          return iterate;
        iterate.certificate = certify(problem, bound_of, iterate.state, iterate.motion);
        if (iterate.certificate.worst() <= converged)
          return iterate;
      }
      return iterate;
    }

    std::vector<PointStatus> status_of(const Iterate &iterate, const FrictionBoundOf &bound_of)
    {
      std::vector<PointStatus> status;
      for (unsigned int i = 0; i < iterate.state.force.size(); ++i)
      {
        const double p        = iterate.state.force[i][0];
        const double friction = tangential(iterate.state.force[i]).norm(),
                     slip     = tangential(iterate.motion[i]).norm();
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
    const FrictionBoundOf coulomb =
        [&](const unsigned int point, const double pressure_force, const double slip)
    {
      const FrictionCoefficient mu = friction(point, slip);
      return FrictionBound{mu.value * pressure_force, mu.value, mu.derivative * pressure_force};
    };
    std::ostringstream tried;
    unsigned int n_iterations = 0;
    const auto solved         = [&](const Iterate &iterate, const std::string &what)
    {
      n_iterations += iterate.n_iterations;
      if (iterate.certificate.worst() <= ContactCertificate::limit)
        return true;
      tried << (tried.str().empty() ? "" : ", ") << what << " (" << iterate.certificate.worst()
            << " after " << iterate.n_iterations << ")";
      return false;
    };
    const auto solution = [&](const Iterate &iterate)
    {
      return ContactSolution{iterate.state,       iterate.motion, status_of(iterate, coulomb),
                             iterate.certificate, n_iterations,   tried.str()};
    };

    for (const double factor : {1., 1. / 4., 1. / 16., 1. / 64.})
    {
      const ComplementarityConstants smaller{constants.normal, factor * constants.tangential};
      const Iterate iterate = newton(problem, coulomb, smaller, start);
      if (solved(iterate, "Newton's method with " + std::to_string(factor) + " c_t"))
        return solution(iterate);
    }
    const Iterate iterate = tresca(problem, coulomb, constants, start);
    if (solved(iterate, "fixed point on the friction bounds"))
      return solution(iterate);
    throw ComputationError("the contact problem of " + std::to_string(problem.n_points()) +
                           " points was not solved; tried, with the largest violation of the laws "
                           "of contact and the iterations: " +
                           tried.str());
  }
} // namespace ringmotor
