// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace ringmotor
{
  /** L D L^T factorisation of a dense real symmetric indefinite matrix by LAPACK (Bunch-Kaufman).
   */
  class DenseLDLT
  {
  public:
    /**
     * Factorises a matrix of @p size rows, given by columns; only the lower triangle is used.
     * @throws ComputationError if it is singular.
     */
    void factorise(const unsigned int size, std::vector<double> matrix);

    /** Number of negative eigenvalues of the factorised matrix. */
    unsigned int n_negative() const;

    /** Replaces @p right_hand_sides, one or several one after the other, by the solutions. */
    void solve(std::vector<double> &right_hand_sides);

  private:
    int size = 0;
    std::vector<double> factors;
    std::vector<int> pivots;
  };
} // namespace ringmotor
