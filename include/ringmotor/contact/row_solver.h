// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_rows.h>

#include <memory>
#include <vector>

namespace ringmotor
{
  /**
   * Solves one set of contact rows after the other for the changes of the forces and of the rigid
   * motions, whichever way takes less time:
   *
   * - a dense matrix by LAPACK, or one for each part of a problem of several parts;
   * - GMRES with the factors of an earlier set of rows as preconditioner. Near the solution
   * Newton's systems differ in a few rows only, each of which takes one step more;
   * - GMRES without a preconditioner, which needs no matrix, where a dense one would be too large.
   */
  class RowSolver
  {
  public:
    /**
     * @param solution the right-hand side, three entries for each touching node and one for each
     * balance; replaced by the solution
     * @return false if a matrix is singular or GMRES does not converge
     */
    bool solve(const ContactProblem &problem, const std::vector<unsigned int> &touching,
               const std::vector<ContactRow> &rows, dealii::Vector<double> &solution);

  private:
    bool solve_with_kept_factors(const ContactRows &rows, dealii::Vector<double> &solution) const;
    bool solve_dense(const ContactRows &rows, dealii::Vector<double> &solution);

    std::unique_ptr<dealii::LAPACKFullMatrix<double>> factors; ///< of the last dense matrix
    std::vector<unsigned int> touching_of_factors, unknowns_of_factors;
  };
} // namespace ringmotor
