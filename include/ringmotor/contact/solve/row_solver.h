// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/chain_of_blocks.h>
#include <ringmotor/contact/solve/slip_factors.h>

#include <memory>
#include <optional>
#include <vector>

namespace ringmotor
{
  /** A preconditioner, kept for systems that are similar to the one it was made for: near a
   * solution Newton's systems differ in a few rows only, each of which takes GMRES one step more.
   */
  template <typename Preconditioner>
  class KeptPreconditioner
  {
  public:
    /** Solves by GMRES with the preconditioner of an earlier system or, if that takes more than
     * @p most_with_kept steps, with a new one. @param solution the right-hand side, replaced
     * @return false if GMRES does not converge; then the solution is left unchanged */
    bool solve(const ContactRows &rows, const double reduction, const unsigned int most_with_kept,
               const unsigned int most_with_new, dealii::Vector<double> &solution);

    /** The steps of GMRES when a preconditioner was made last; nothing if it did not converge. */
    std::optional<unsigned int> steps_with_new() const { return of_a_new; }

  private:
    std::shared_ptr<const Preconditioner> kept;   ///< also by copies of this object
    bool is_far                          = false; ///< it was of no use for the last system
    std::optional<unsigned int> of_a_new = 0;
  };

  /**
   * Solves one set of contact rows after the other for the changes of the forces and of the rigid
   * motions, in the fastest of these ways:
   *
   * - a dense matrix by LAPACK, or one for each part of a problem of several parts;
   * - GMRES with dense factors in single precision as preconditioner;
   * - GMRES with chains of blocks as preconditioner, which needs no dense matrix, where its factors
   * are estimated to cost less, as long as it takes few steps.
   */
  class RowSolver
  {
  public:
    /**
     * @param solution the right-hand side, three entries for each touching node and one for each
     * balance; replaced by the solution
     * @param reduction of the residual at which GMRES stops
     * @return false if a matrix is singular or GMRES does not converge
     */
    bool solve(const ContactProblem &problem, const std::vector<unsigned int> &touching,
               const std::vector<ContactRow> &rows, dealii::Vector<double> &solution,
               const double reduction = 1e-8);

  private:
    /** With chains of blocks, if that is estimated to be faster than dense factors. @param of_dense
     * what those cost, in operations of matrix products; infinity if there are too many unknowns
     * @return false if it is not, or GMRES does not converge; then nothing is changed */
    bool solve_by_blocks(const ContactRows &rows, const double reduction, const double of_dense,
                         dealii::Vector<double> &solution);

    KeptPreconditioner<ChainOfBlocks> blocks;
    KeptPreconditioner<SlipFactors> factors;
  };
} // namespace ringmotor
