// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/lu_factors.h>
#include <ringmotor/contact/solve/ring_of_parts.h>
#include <ringmotor/contact/solve/row_solver.h>

#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Unknowns from which on keeping factors pays off: below, new ones take milliseconds. */
    constexpr unsigned int fewest_for_kept_factors = 300;
    /** What GMRES with chains of blocks takes longer than with dense factors, for more steps:
     * operations, and in proportion to those of its factors. */
    constexpr double steps_by_blocks = 1e8, longer_by_blocks = 6.;
    /** Steps of GMRES with chains of blocks: so many take as long as new blocks, or as dense
     * factors; so many for each unknown of their small system; near a solution at most so many. */
    constexpr unsigned int many_steps = 12, most_by_blocks = 60;
    constexpr double many_per_unknown = 1. / 20.;
    /** Steps of GMRES with the factors of the system itself, in single precision. */
    constexpr unsigned int enough_for_rounding = 12;
    /** Unknowns up to which a dense matrix is made where GMRES fails, in a second or two. More
     * occur only far from any solution. */
    constexpr unsigned int most_dense = 4000;
    constexpr double infinity         = std::numeric_limits<double>::infinity();

    /** Ends GMRES as soon as its pace shows that it will not converge in time. */
    class PaceControl : public SolverControl
    {
    public:
      PaceControl(const unsigned int most_steps, const double tolerance)
          : SolverControl(most_steps, tolerance, false, false)
      {
      }

      State check(const unsigned int step, const double residual) override
      {
        // Later steps gain more than earlier ones, at best about twice as much.
        constexpr unsigned int of_pace = 4;
        constexpr double later         = 2.;
        const State state              = SolverControl::check(step, residual);
        residuals.push_back(residual);
        if (state != iterate || residuals.size() <= of_pace)
          return state;
        const double before = residuals[residuals.size() - 1 - of_pace],
                     gain   = std::log(before / residual) / of_pace,
                     wanted = std::log(residual / tolerance()) / (max_steps() - step);
        return wanted > later * gain ? failure : iterate;
      }

    private:
      std::vector<double> residuals; ///< by step
    };

    /** @param solution also the start
     * @return the number of steps in which the residual was reduced, at most @p most_steps without
     * restarts, which would make it stagnate; nothing if it was not */
    template <typename Matrix, typename Preconditioner>
    std::optional<unsigned int>
    gmres(const Matrix &matrix, const Preconditioner &preconditioner, const unsigned int most_steps,
          const double reduction, const Vector<double> &right_hand_side, Vector<double> &solution)
    {
      if (right_hand_side.l2_norm() == 0.)
      {
        solution = 0.;
        return 0;
      }
      PaceControl control(most_steps, reduction * right_hand_side.l2_norm());
      // Flexible, since a preconditioner in single precision is not quite linear: plain GMRES ends
      // with residuals a hundred times as large as it estimates.
      SolverFGMRES<Vector<double>> solver(
          control, SolverFGMRES<Vector<double>>::AdditionalData(most_steps + 1));
      try
      {
        solver.solve(matrix, solution, right_hand_side, preconditioner);
      }
      catch (const SolverControl::NoConvergence &)
      {
        return {};
      }
      return control.last_step();
    }

    bool solve_dense(const ContactRows &rows, Vector<double> &solution)
    {
      const std::vector<unsigned int> &unknowns = rows.unknowns();
      LAPACKFullMatrix<double> matrix           = rows.matrix_of(unknowns, unknowns);
      if (!factorise(matrix))
        return false;
      Vector<double> values(unknowns.size());
      for (unsigned int i = 0; i < unknowns.size(); ++i)
        values[i] = solution[unknowns[i]];
      matrix.solve(values);
      for (unsigned int i = 0; i < unknowns.size(); ++i)
        solution[unknowns[i]] = values[i];
      return true;
    }
  } // namespace

  template <typename Preconditioner>
  bool KeptPreconditioner<Preconditioner>::solve(const ContactRows &rows, const double reduction,
                                                 const unsigned int most_with_kept,
                                                 const unsigned int most_with_new,
                                                 Vector<double> &solution)
  {
    const Vector<double> right_hand_side = solution;
    const auto solved                    = [&](const unsigned int most_steps)
    {
      solution = kept->start(right_hand_side);
      return gmres(rows, *kept, most_steps, reduction, right_hand_side, solution);
    };
    // Far from the solution systems differ too much; after a failure the next one skips this.
    const bool may_do = kept && !is_far && kept->fit(rows);
    if (may_do && solved(most_with_kept))
      return true;
    is_far   = may_do;
    kept     = std::make_shared<const Preconditioner>(rows);
    of_a_new = kept->is_regular() ? solved(most_with_new) : std::nullopt;
    if (of_a_new)
      return true;
    kept.reset();
    solution = right_hand_side;
    return false;
  }

  bool RowSolver::solve_by_blocks(const ContactRows &rows, const double reduction,
                                  const double of_dense, Vector<double> &solution)
  {
    if (rows.contact_problem().structure().n_blocks() <= 1)
      return false;
    const ChainOfBlocks::Cost cost = ChainOfBlocks::cost_of(rows);
    const unsigned int enough      = cost.has_chains ? most_by_blocks : many_steps;
    const bool are_slow            = blocks.steps_with_new().value_or(most_by_blocks + 1) > enough;
    const double of_blocks =
        are_slow ? infinity : steps_by_blocks + longer_by_blocks * cost.n_operations;
    const auto many = std::max<unsigned int>(many_steps, many_per_unknown * cost.n_small);
    return of_blocks <= of_dense && blocks.solve(rows, reduction, many, most_by_blocks, solution);
  }

  bool RowSolver::solve(const ContactProblem &problem, const std::vector<unsigned int> &touching,
                        const std::vector<ContactRow> &contact_rows, Vector<double> &solution,
                        const double reduction)
  {
    const ContactRows rows(problem, touching, contact_rows);
    for (unsigned int a = 0; a < touching.size(); ++a)
      if (!contact_rows[a].has_friction)
        solution[3 * a + 1] = solution[3 * a + 2] = 0.;
    const unsigned int n = rows.unknowns().size();
    if (n == 0) // LAPACK does not take empty matrices
      return true;
    RingOfParts ring(rows);
    // An LU factorisation takes 2/3 n^3 operations.
    const bool is_ring    = ring.n_parts() > 1 && ring.n_operations() < 2. / 3. * std::pow(n, 3);
    const bool has_dense  = (is_ring ? ring.largest_part() : n) <= most_dense;
    const double of_dense = !has_dense ? infinity
                            : is_ring  ? ring.n_operations()
                                       : SlipFactors::cost_of(rows);
    if (solve_by_blocks(rows, reduction, of_dense, solution))
      return true;
    if (!has_dense)
      return false;
    if (is_ring)
      return ring.solve(solution);
    // So many steps take about as long as new factors.
    if (n >= fewest_for_kept_factors &&
        factors.solve(rows, reduction, std::max(10u, n / 60), enough_for_rounding, solution))
      return true;
    return solve_dense(rows, solution);
  }
} // namespace ringmotor
