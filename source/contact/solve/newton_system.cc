// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/solve/newton_system.h>

#include <algorithm>
#include <cmath>

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
  } // namespace

  /** Stick or slip at a touching node, chosen from the last iterate. */
  struct NewtonSystem::Choice
  {
    bool sticks = false;
    Tangential towards; ///< tau / |tau|
    double limit = 0.;  ///< the friction bound
    double ratio = 0.;  ///< limit / |tau|
  };

  NewtonSystem::NewtonSystem(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                             const ComplementarityConstants &constants,
                             const std::vector<PointVector> &seen, ContactState &state,
                             std::vector<PointVector> &motion)
      : problem(problem), constants(constants)
  {
    std::vector<Choice> choices;
    bool lost_force = false;
    for (unsigned int i = 0; i < state.force.size(); ++i)
    {
      PointVector &force = state.force[i];
      const double reach = force[0] - constants.normal * seen[i][0];
      if (reach > 0.)
      {
        touching.push_back(i);
        choices.push_back(choice_of(force, seen[i], bound_of(i, reach, tangential_norm(seen[i]))));
      }
      else
      {
        lost_force = lost_force || force != PointVector();
        force      = 0.;
      }
    }
    if (lost_force)
      motion = problem.relative_motion(state);
    rows.resize(touching.size());
    for (unsigned int a = 0; a < touching.size(); ++a)
    {
      const unsigned int point = touching[a];
      // Rows in N: forces and scaled motions are of similar size.
      rows[a].by_motion[0][0]    = constants.normal;
      rows[a].right_hand_side[0] = -constants.normal * motion[point][0];
      if (choices[a].sticks)
        for (unsigned int c = 1; c < 3; ++c)
        {
          rows[a].by_motion[c][c]    = constants.tangential;
          rows[a].right_hand_side[c] = -constants.tangential * motion[point][c];
        }
      else
        add_slip(rows[a], choices[a], state.force[point], motion[point],
                 bound_of(point, state.force[point][0], tangential_norm(motion[point])));
    }
    balances = problem.balances(state);
  }

  NewtonSystem::Choice NewtonSystem::choice_of(const PointVector &force, const PointVector &motion,
                                               const FrictionBound &bound) const
  {
    const Tangential tau = tangential(force) - constants.tangential * tangential(motion);
    const double size    = tau.norm();
    Choice choice;
    choice.sticks = size <= bound.value && bound.value > 0.;
    choice.limit  = bound.value;
    if (size > 0.)
    {
      choice.towards = tau / size;
      choice.ratio   = bound.value / size;
    }
    return choice;
  }

  /** Newton's linearisation of F_t = bound(p, |slip|) tau/|tau|. */
  void NewtonSystem::add_slip(ContactRow &row, const Choice &choice, const PointVector &force,
                              const PointVector &motion, const FrictionBound &bound) const
  {
    const Tangential slip     = tangential(motion);
    const double slip_size    = slip.norm();
    const Tangential &towards = choice.towards;
    row.has_friction = tangential(force).norm() > 0. || choice.limit != 0. || bound.value != 0. ||
                       bound.by_pressure != 0.;
    // Where F_t is still below the bound, its unit vector would leave motions along it undetermined
    // (Hueeber, Stadler and Wohlmuth 2008); the limit is the same.
    Tangential direction = tangential(force);
    if (direction.norm() > 0.)
      direction /= std::max(choice.limit, direction.norm());
    for (unsigned int c = 0; c < 2; ++c)
    {
      for (unsigned int d = 0; d < 2; ++d)
      {
        // d(tau/|tau|) = (1 - e e^T) d tau / |tau|, d tau = dF_t - c_t d slip, one e is that of F_t
        const double turn           = choice.ratio * ((c == d) - direction[c] * towards[d]);
        row.by_force[1 + c][1 + d]  = (c == d) - turn;
        row.by_motion[1 + c][1 + d] = constants.tangential * turn;
        if (slip_size > 0.)
          row.by_motion[1 + c][1 + d] -= towards[c] * bound.by_slip * slip[d] / slip_size;
      }
      row.by_force[1 + c][0]     = -towards[c] * bound.by_pressure;
      row.right_hand_side[1 + c] = bound.value * towards[c] - force[1 + c];
    }
  }

  bool NewtonSystem::solve(RowSolver &solver, const double reduction, ContactState &state) const
  {
    Vector<double> solution(3 * touching.size() + balances.size());
    for (unsigned int a = 0; a < touching.size(); ++a)
      for (unsigned int c = 0; c < 3; ++c)
        solution[3 * a + c] = rows[a].right_hand_side[c];
    for (unsigned int r = 0; r < balances.size(); ++r)
      solution[3 * touching.size() + r] = -balances[r];
    if (!solver.solve(problem, touching, rows, solution, reduction) ||
        !std::isfinite(solution.l1_norm()))
      return false;
    for (unsigned int a = 0; a < touching.size(); ++a)
      for (unsigned int c = 0; c < 3; ++c)
        state.force[touching[a]][c] += solution[3 * a + c];
    for (unsigned int r = 0; r < balances.size(); ++r)
      state.rigid[r] += solution[3 * touching.size() + r];
    return true;
  }
} // namespace ringmotor
