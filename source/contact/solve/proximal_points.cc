// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/solve/proximal_points.h>
#include <ringmotor/contact/solve/proximal_problem.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ringmotor
{
  namespace
  {
    /** The stiffness of elastic nodes against the rigid motions with their own compliance alone: a
     * scale for the springs of these motions. */
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

      /** That of the touching nodes, or of the stiffest node if that is larger, times @p strength.
       */
      std::vector<double> against(const ContactState &state, const double strength) const
      {
        std::vector<double> stiffness; // with the sign for each motion
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
          stiffness.push_back(strength *
                              (std::abs(largest) > std::abs(of_touching) ? largest : of_touching));
        }
        return stiffness;
      }

    private:
      std::vector<std::vector<double>> of_node; ///< by rigid motion
    };
  } // namespace

  ContactIterate proximal_points(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                                 const ComplementarityConstants &constants,
                                 const ContactState &start, RowSolver &solver,
                                 const unsigned int most_points)
  {
    constexpr double weakest = 1e-8, strongest = 1e5, nearly = 0.05, fulfilled = 1e-10;
    constexpr NewtonLimits finishing;
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
    // Of the springs, relative to the bodies themselves.
    double strength = start.n_pressed() > 0 ? 1. / 16. : 1.;
    for (unsigned int step = 0; step < most_points && strength < strongest; ++step)
    {
      // Errors of the links must add up to little (Rockafellar 1976): a link that is not solved
      // better than its start does not lead on.
      constexpr double coarsest = 1e-3, share = 0.03;
      const NewtonLimits of_link{
          finishing.most_iterations,
          std::clamp(share * found.certificate.worst(), 0.3 * fulfilled, coarsest)};
      const ProximalProblem::Springs springs{strength / constants.normal,
                                             strength / constants.tangential,
                                             rigid_stiffness.against(found.state, strength)};
      const ProximalProblem proximal(problem, found.state, springs);
      const ComplementarityConstants softer{constants.normal / (1. + strength),
                                            constants.tangential / (1. + strength)};
      RowSolver of_springs; // whose systems differ
      const ContactIterate next =
          newton(proximal, bound_of, softer, found.state, of_link, of_springs);
      found.n_iterations = n_systems += next.n_iterations;
      if (next.failed || !(next.certificate.worst() <= of_link.converged))
      {
        strength *= 8.;
        continue;
      }
      found    = judged(next.state);
      strength = std::max(weakest, strength / 16.);
      if (found.certificate.worst() > nearly && strength > weakest)
        continue;
      ContactIterate exact = newton(problem, bound_of, constants, found.state, finishing, solver);
      exact.n_iterations = found.n_iterations = n_systems += exact.n_iterations;
      if (exact.certified())
        return exact;
      // The springs' forces vanish as the chain converges, so its limit solves the problem itself,
      // also where that has more than one solution and Newton's systems are singular.
      if (found.certificate.worst() <= fulfilled)
        return found;
    }
    // A state that the chain did not confirm is rejected, even if it fulfils the laws.
    found.failed = found.certificate.holds();
    return found;
  }
} // namespace ringmotor
