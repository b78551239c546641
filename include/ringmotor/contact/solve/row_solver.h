// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/slip_factors.h>

#include <memory>
#include <vector>

namespace ringmotor
{
  /**
   * Solves one set of contact rows after the other for the changes of the forces and of the rigid
   * motions, in the fastest of these ways:
   *
   * - a dense matrix by LAPACK, or one for each part of a problem of several parts;
   * - GMRES with the factors of an earlier set of rows as preconditioner. Near the solution
   * Newton's systems differ in a few rows only, each of which takes one step more;
   * - GMRES with a chain of blocks as preconditioner, which needs no dense matrix, for many
   * unknowns.
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
    /** With the factors of an earlier system or of this one.
     * @return false if these factors are not good enough; then the solution is left unchanged */
    bool solve_with_factors(const ContactRows &rows, const double reduction,
                            dealii::Vector<double> &solution);

    std::unique_ptr<SlipFactors> factors; ///< of the last system that needed new ones
    bool is_far = false;                  ///< the factors were of no use for the last system
  };
} // namespace ringmotor
