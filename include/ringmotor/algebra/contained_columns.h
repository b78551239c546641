// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <complex>
#include <vector>

namespace ringmotor
{
  /**
   * The columns Y' nearest to Y for which A - Y' Y'^H has no negative eigenvalue, where A is
   * Hermitian: with A = L L^H and the singular values of L^-1 Y = U S W^H, Y' = L U min(S, 1) W^H.
   * "Nearest" is meant in the norm of L^-1, and holds for every unitarily invariant one.
   * @param n_rows of A and Y
   * @param a column by column, without negative eigenvalues except by rounding
   * @param y column after column, like the result
   * @throw ComputationError if @p a has negative eigenvalues
   */
  std::vector<std::complex<double>> contained_columns(const unsigned int n_rows,
                                                      std::vector<std::complex<double>> a,
                                                      std::vector<std::complex<double>> y);
} // namespace ringmotor
