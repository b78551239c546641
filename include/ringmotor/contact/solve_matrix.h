// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

namespace ringmotor
{
  /**
   * Replaces a right hand side by the solution of a linear problem. Where most of a large matrix is
   * zero, as with many moments of a steady state, each of which is tied to the one before only, it
   * is factorised without its zeros.
   *
   * @return false if the matrix is singular
   */
  bool solve_matrix(const dealii::FullMatrix<double> &matrix, dealii::Vector<double> &solution);
} // namespace ringmotor
