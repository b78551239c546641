// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/lapack_full_matrix.h>

#include <complex>
#include <limits>
#include <vector>

namespace ringmotor::tests
{
  /** The eigenvalues of the Hermitian part of a matrix, given column by column, in ascending order.
   */
  inline std::vector<double> hermitian_eigenvalues(const unsigned int n,
                                                   const std::vector<std::complex<double>> &matrix)
  {
    dealii::LAPACKFullMatrix<double> real(2 * n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        const std::complex<double> entry = 0.5 * (matrix[j * n + i] + std::conj(matrix[i * n + j]));
        real(i, j) = real(n + i, n + j) = entry.real();
        real(n + i, j)                  = entry.imag();
        real(i, n + j)                  = -entry.imag();
      }
    constexpr double all = std::numeric_limits<double>::max();
    dealii::Vector<double> doubled;
    dealii::FullMatrix<double> vectors;
    real.compute_eigenvalues_symmetric(-all, all, 0., doubled, vectors);
    std::vector<double> values;
    for (unsigned int i = 0; i < n; ++i)
      values.push_back(doubled[2 * i]);
    return values;
  }
} // namespace ringmotor::tests
