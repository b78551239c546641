// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/full_matrix.h>

namespace ringmotor
{
  /** A matrix as the product of orthonormal columns and their weights, as many as its numerical
   * rank. */
  struct RankFactors
  {
    dealii::FullMatrix<double> columns; ///< of the height of the matrix
    dealii::FullMatrix<double> weights; ///< of its width

    /** Householder QR with column pivoting (LAPACK). Anything below @p tolerance times the largest
     * column counts as rounding. */
    RankFactors(const dealii::FullMatrix<double> &matrix, const double tolerance);
  };
} // namespace ringmotor
