// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace ringmotor
{
  /**
   * The columns Y' nearest to some Y for which A - Y' Y'^H has no negative eigenvalue, where A is
   * Hermitian: with A = L L^H and the singular values of L^-1 Y = U S W^H, Y' = L U min(S, 1) W^H.
   * Of all such columns these have the least L^-1 (Y - Y'), in any unitarily invariant norm. If A
   * is singular, Y is first replaced by columns in the range of A that agree with it in as many
   * rows as A has rank (the pivots of a Cholesky factorisation with pivoting).
   */
  class ContainedColumns
  {
  public:
    /** @param n_rows of A @param a column by column, without negative eigenvalues except by
     * rounding; of its entries above the diagonal nothing is read */
    ContainedColumns(const unsigned int n_rows, std::vector<std::complex<double>> a);

    /** @param y column after column, like the result; unchanged if it is contained */
    std::vector<std::complex<double>> nearest_to(const std::vector<std::complex<double>> &y) const;

  private:
    const std::size_t n_rows;
    std::vector<int> pivots;                 ///< rows by which L is lower triangular, from 0 on
    std::vector<std::complex<double>> upper; ///< these rows of L, a square matrix
    std::vector<std::complex<double>> l;     ///< all rows, and as many columns as the rank
  };
} // namespace ringmotor
