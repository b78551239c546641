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
      if (row == column)
        SymmetricElements::add({row}, {value});
      else
        SymmetricElements::add({row, column}, {0., value, 0.});
    }
  };
} // namespace ringmotor::tests
