// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <complex>
#include <vector>

namespace ringmotor
{
  /**
   * The columns Y' nearest to Y for which A - Y' Y'^H has no negative eigenvalue, where A is
   * Hermitian: with A = L L^H and the singular values of L^-1 Y = U S W^H, Y' = L U min(S, 1) W^H.
   * Of all such columns these have the least L^-1 (Y - Y'), in any unitarily invariant norm. If A
   * is singular, Y is first replaced by columns in the range of A that agree with it in as many
   * rows as A has rank (the pivots of a Cholesky factorisation with pivoting).
   * @param n_rows of A and Y
   * @param a column by column, without negative eigenvalues except by rounding; of its entries
   * above the diagonal nothing is read
   * @param y column after column, like the result
   */
  std::vector<std::complex<double>> contained_columns(const unsigned int n_rows,
                                                      std::vector<std::complex<double>> a,
                                                      std::vector<std::complex<double>> y);
} // namespace ringmotor
