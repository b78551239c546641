// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/full_matrix.h>

#include <cstddef>
#include <vector>

namespace ringmotor
{
  enum class Transposed
  {
    no,
    yes
  };

  /** result += factor * a b, or a^T b, for dense matrices by columns; @p b has @p n_inner rows.
   * Fast for few columns, too, where a general product would spend its time on copying a. */
  void add_product(const double factor, const Transposed transposed, const std::vector<double> &a,
                   const std::size_t n_inner, const std::vector<double> &b,
                   std::vector<double> &result);

  /** a b, or a^T b; zero if the inner dimension is zero. */
  dealii::FullMatrix<double> product(const dealii::FullMatrix<double> &a,
                                     const dealii::FullMatrix<double> &b,
                                     const Transposed transposed_a = Transposed::no);

  dealii::FullMatrix<double> transposed(const dealii::FullMatrix<double> &matrix);
  /** Each of them. */
  std::vector<dealii::FullMatrix<double>>
  transposed(const std::vector<dealii::FullMatrix<double>> &matrices);
} // namespace ringmotor
