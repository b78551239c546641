// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace ringmotor
{
  /**
   * An energy computed by quadrature: sum over the rows of weight (row . u)^2, where a row is, for
   * example, a strain at a quadrature point. The squares keep the digits of nearly strain-free
   * states; the matrix loses them.
   */
  struct SumOfSquares
  {
    dealii::FullMatrix<double> rows; ///< a column for each local degree of freedom
    std::vector<double> weights;     ///< by row

    /** Sets @p matrix to the sum of weight row^T row. */
    void fill(dealii::FullMatrix<double> &matrix) const;

    /** The sum for each of @p fields. */
    std::vector<double> products(const std::vector<dealii::Vector<double>> &fields) const;
  };
} // namespace ringmotor
