// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/lapack_full_matrix.h>

namespace ringmotor
{
  /** LU factors in place. @return false if the matrix is singular */
  template <typename Number>
  bool factorise(dealii::LAPACKFullMatrix<Number> &matrix)
  {
    try
    {
      matrix.compute_lu_factorization();
      return true;
    }
    catch (const dealii::LACExceptions::ExcSingular &)
    {
      return false;
    }
  }
} // namespace ringmotor
