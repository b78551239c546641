// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/lu_factors.h>
#include <ringmotor/contact/solve/chain_of_blocks.h>
#include <ringmotor/contact/solve/ring_of_parts.h>
#include <ringmotor/contact/solve/row_solver.h>

#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Unknowns from which on keeping factors pays off: below, new ones take milliseconds. */
    constexpr unsigned int fewest_for_kept_factors = 300;
    /** Unknowns from which on GMRES with a chain of blocks is faster than dense factors. */
    constexpr unsigned int fewest_for_blocks = 2600;
    /** Unknowns up to which a dense matrix is made where GMRES fails, in a second or two. More
     * occur only far from any solution. */
    constexpr unsigned int most_dense = 4000;

    /** @param solution also the start
     * @return whether the residual was reduced in @p most_steps steps, without restarts, which
     * would make it stagnate */
    template <typename Matrix, typename Preconditioner>
    bool gmres(const Matrix &matrix, const Preconditioner &preconditioner,
               const unsigned int most_steps, const double reduction,
               const Vector<double> &right_hand_side, Vector<double> &solution)
    {
      if (right_hand_side.l2_norm() == 0.)
      {
        solution = 0.;
        return true;
      }
      SolverControl control(most_steps, reduction * right_hand_side.l2_norm(), false, false);
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
        return false;
      }
      return true;
    }

    bool solve_by_blocks(const ContactRows &rows, const double reduction, Vector<double> &solution)
    {
      constexpr unsigned int most_steps = 60; // near a solution it takes 10 to 40
      const ChainOfBlocks blocks(rows);
      Vector<double> result(solution.size());
      if (!blocks.is_regular() || !gmres(rows, blocks, most_steps, reduction, solution, result))
        return false;
      solution = result;
      return true;
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
    if (n >= fewest_for_blocks && problem.structure().n_blocks() > 1 &&
        solve_by_blocks(rows, reduction, solution))
      return true;
    RingOfParts ring(rows);
    // An LU factorisation takes 2/3 n^3 operations.
    const bool is_ring = ring.n_parts() > 1 && ring.n_operations() < 2. / 3. * std::pow(n, 3);
    if ((is_ring ? ring.largest_part() : n) > most_dense)
      return false;
    if (is_ring)
      return ring.solve(solution);
    if (n >= fewest_for_kept_factors && solve_with_factors(rows, reduction, solution))
      return true;
    return solve_dense(rows, solution);
  }

  bool RowSolver::solve_with_factors(const ContactRows &rows, const double reduction,
                                     Vector<double> &solution)
  {
    const Vector<double> right_hand_side = solution;
    const auto solved                    = [&](const unsigned int most_steps)
    {
      solution = factors->start(right_hand_side);
      return gmres(rows, *factors, most_steps, reduction, right_hand_side, solution);
    };
    // Far from the solution systems differ too much; after a failure the next one skips this.
    const bool may_do = factors && !is_far && factors->fit(rows);
    // So many steps take about as long as new factors.
    if (may_do && solved(std::max<std::size_t>(10, rows.unknowns().size() / 60)))
      return true;
    is_far                                     = may_do;
    factors                                    = std::make_unique<SlipFactors>(rows);
    constexpr unsigned int enough_for_rounding = 12;
    if (factors->is_regular() && solved(enough_for_rounding))
      return true;
    factors.reset();
    solution = right_hand_side;
    return false;
  }
} // namespace ringmotor
