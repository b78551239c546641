// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/newton_system.h>
#include <ringmotor/contact/solve_matrix.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Tangential = Tensor<1, 2>;

    /** Unknowns up to which the dense matrix is the faster one. */
    constexpr unsigned int most_dense = 2500;

    Tangential tangential(const PointVector &vector)
    {
      Tangential part;
      part[0] = vector[1];
      part[1] = vector[2];
      return part;
    }
  } // namespace

  /** What friction at a touching node is to do, chosen from the last iterate. */
  struct NewtonSystem::Choice
  {
    bool sticks = false;
    Tangential towards; ///< tau / |tau|
    double limit = 0.;  ///< the friction bound
    double ratio = 0.;  ///< limit / |tau|
  };

  NewtonSystem::NewtonSystem(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                             const ComplementarityConstants &constants, ContactState &state,
                             std::vector<PointVector> &motion)
      : problem(problem), constants(constants)
  {
    std::vector<Choice> choices;
    bool lost_force = false;
    for (unsigned int i = 0; i < state.force.size(); ++i)
    {
      PointVector &force = state.force[i];
      const double reach = force[0] - constants.normal * motion[i][0];
      if (reach > 0.)
      {
        touching.push_back(i);
        choices.push_back(
            choice_of(force, motion[i], bound_of(i, reach, tangential_norm(motion[i]))));
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
      // Rows in N: forces and scaled motions are of a size.
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
    // Where F_t is not yet at the bound, its direction would leave motions along it free
    // (Hueeber, Stadler and Wohlmuth 2008); the limit is the same.
    Tangential direction = tangential(force);
    if (direction.norm() > 0.)
      direction /= std::max(choice.limit, direction.norm());
    for (unsigned int c = 0; c < 2; ++c)
    {
      for (unsigned int d = 0; d < 2; ++d)
      {
        // d(tau/|tau|) = (1 - e e^T) d tau / |tau|, d tau = dF_t - c_t d slip, one e of F_t
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

  Vector<double> NewtonSystem::right_hand_side() const
  {
    Vector<double> result(3 * touching.size() + balances.size());
    for (unsigned int a = 0; a < touching.size(); ++a)
      for (unsigned int c = 0; c < 3; ++c)
        result[3 * a + c] = rows[a].right_hand_side[c];
    for (unsigned int r = 0; r < balances.size(); ++r)
      result[3 * touching.size() + r] = -balances[r];
    return result;
  }

  bool NewtonSystem::solve(ContactState &state) const
  {
    Vector<double> solution;
    const unsigned int n_unknowns =
        balances.size() + touching.size() +
        2 * std::count_if(rows.begin(), rows.end(),
                          [](const ContactRow &row) { return row.has_friction; });
    const bool solved = n_unknowns <= most_dense ? solve_dense(solution) : solve_krylov(solution);
    if (!solved || !std::isfinite(solution.l1_norm()))
      return false;
    for (unsigned int a = 0; a < touching.size(); ++a)
      for (unsigned int c = 0; c < 3; ++c)
        state.force[touching[a]][c] += solution[3 * a + c];
    for (unsigned int r = 0; r < balances.size(); ++r)
      state.rigid[r] += solution[3 * touching.size() + r];
    return true;
  }

  bool NewtonSystem::solve_dense(Vector<double> &solution) const
  {
    // Forces that are zero and stay zero, as all friction of surfaces without it, are no unknowns.
    const unsigned int n = touching.size(), size = 3 * n + balances.size();
    std::vector<types::global_dof_index> unknowns;
    for (unsigned int row = 0; row < size; ++row)
      if (row >= 3 * n || row % 3 == 0 || rows[row / 3].has_friction)
        unknowns.push_back(row);
    solution.reinit(size);
    if (unknowns.empty()) // LAPACK does not take empty matrices
      return true;
    FullMatrix<double> matrix(unknowns.size(), unknowns.size()), derivatives;
    problem.derivatives(touching, derivatives);
    for (unsigned int i = 0; i < unknowns.size() && unknowns[i] < 3 * n; ++i)
    {
      const unsigned int a = unknowns[i] / 3, c = unknowns[i] % 3;
      for (unsigned int d = 0; d < 3; ++d)
        if (const double factor = rows[a].by_motion[c][d]; factor != 0.)
          for (unsigned int j = 0; j < unknowns.size(); ++j)
            matrix(i, j) += factor * derivatives(3 * a + d, unknowns[j]);
      for (unsigned int j = i - std::min(i, c); j < unknowns.size() && unknowns[j] < 3 * (a + 1);
           ++j)
        if (unknowns[j] >= 3 * a)
          matrix(i, j) += rows[a].by_force[c][unknowns[j] % 3];
    }
    problem.balance_derivatives(touching, derivatives);
    const unsigned int first = unknowns.size() - balances.size();
    for (unsigned int r = 0; r < balances.size(); ++r)
      for (unsigned int j = 0; j < unknowns.size(); ++j)
        matrix(first + r, j) = derivatives(r, unknowns[j]);
    const Vector<double> all = right_hand_side();
    Vector<double> part(unknowns.size());
    for (unsigned int i = 0; i < unknowns.size(); ++i)
      part[i] = all[unknowns[i]];
    if (!solve_matrix(matrix, part))
      return false;
    for (unsigned int i = 0; i < unknowns.size(); ++i)
      solution[unknowns[i]] = part[i];
    return true;
  }

  namespace
  {
    /** The rows of a Newton system as an operator, with rigid motions scaled so that their columns
     * and balances are as long as those of a force. */
    class MatrixFreeSystem
    {
    public:
      MatrixFreeSystem(const ContactProblem &problem, const std::vector<unsigned int> &touching,
                       const std::vector<ContactRow> &rows)
          : problem(problem), touching(touching),
            rows(rows), change{std::vector<PointVector>(problem.n_points()),
                               std::vector<double>(problem.n_rigid())}
      {
        problem.balance_derivatives(touching, balance);
        const unsigned int n = 3 * touching.size();
        for (unsigned int r = 0; r < problem.n_rigid(); ++r)
        {
          column_scale.push_back(1.);
          row_scale.push_back(1.);
          Vector<double> unit(n + problem.n_rigid()), column(unit);
          unit[n + r] = 1.;
          multiply(column, unit);
          double of_column = 0., of_row = 0.;
          for (unsigned int i = 0; i < n; ++i)
          {
            of_column += column[i] * column[i];
            of_row += balance(r, i) * balance(r, i);
          }
          column_scale[r] = of_column > 0. ? 1. / std::sqrt(of_column) : 1.;
          row_scale[r]    = of_row > 0. ? 1. / std::sqrt(of_row) : 1.;
        }
      }

      void vmult(Vector<double> &product, const Vector<double> &vector) const
      {
        multiply(product, vector);
      }
      void scale_right_hand_side(Vector<double> &vector) const
      {
        for (unsigned int r = 0; r < row_scale.size(); ++r)
          vector[3 * touching.size() + r] *= row_scale[r];
      }
      void unscale_solution(Vector<double> &vector) const
      {
        for (unsigned int r = 0; r < column_scale.size(); ++r)
          vector[3 * touching.size() + r] *= column_scale[r];
      }

    private:
      void multiply(Vector<double> &product, const Vector<double> &vector) const
      {
        const unsigned int n = touching.size(), n_rigid = change.rigid.size();
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int c = 0; c < 3; ++c)
            change.force[touching[a]][c] = vector[3 * a + c];
        for (unsigned int r = 0; r < column_scale.size(); ++r)
          change.rigid[r] = column_scale[r] * vector[3 * n + r];
        const std::vector<PointVector> motion = problem.motion_by(change);
        for (unsigned int a = 0; a < n; ++a)
        {
          const PointVector result = rows[a].by_motion * motion[touching[a]] +
                                     rows[a].by_force * change.force[touching[a]];
          for (unsigned int c = 0; c < 3; ++c)
            product[3 * a + c] = result[c];
        }
        for (unsigned int r = 0; r < row_scale.size(); ++r)
        {
          double sum = 0.;
          for (unsigned int i = 0; i < 3 * n; ++i)
            sum += balance(r, i) * vector[i];
          for (unsigned int s = 0; s < n_rigid; ++s)
            sum += balance(r, 3 * n + s) * change.rigid[s];
          product[3 * n + r] = row_scale[r] * sum;
        }
      }

      const ContactProblem &problem;
      const std::vector<unsigned int> &touching;
      const std::vector<ContactRow> &rows;
      FullMatrix<double> balance;
      std::vector<double> column_scale, row_scale;
      mutable ContactState change; ///< zero where nothing touches
    };
  } // namespace

  bool NewtonSystem::solve_krylov(Vector<double> &solution) const
  {
    constexpr unsigned int most_steps = 1200, basis = 1200;
    constexpr double reduction = 1e-9;
    const MatrixFreeSystem system(problem, touching, rows);
    Vector<double> right_hand_side = this->right_hand_side();
    system.scale_right_hand_side(right_hand_side);
    solution.reinit(right_hand_side.size());
    const double norm = right_hand_side.l2_norm();
    if (norm == 0.)
      return true;
    SolverControl control(most_steps, reduction * norm, false, false);
    SolverGMRES<Vector<double>> gmres(
        control, SolverGMRES<Vector<double>>::AdditionalData(basis + 2, /*right =*/true));
    try
    {
      gmres.solve(system, solution, right_hand_side, PreconditionIdentity());
    }
    catch (const SolverControl::NoConvergence &error)
    {
      return false;
    }
    system.unscale_solution(solution);
    return true;
  }
} // namespace ringmotor
