// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sparse_ldlt.h>

namespace ringmotor::tests
{
  /** A symmetric matrix given by its entries, in either triangle; those given more than once are
   * added. */
  struct SymmetricTriplets : SymmetricElements
  {
    void add(const unsigned int row, const unsigned int column, const double value)
    {
      dealii::FullMatrix<double> entry(row == column ? 1 : 2, row == column ? 1 : 2);
      entry(0, entry.n() - 1) = entry(entry.m() - 1, 0) = value;
      SymmetricElements::add(row == column ? std::vector<unsigned int>{row}
                                           : std::vector<unsigned int>{row, column},
                             entry);
    }
  };
} // namespace ringmotor::tests
