// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/sparse_ldlt.h>

#include <deal.II/lac/full_matrix.h>

namespace ringmotor::tests
{
  /** A symmetric matrix given by its entries, in either triangle, and by small dense matrices; what
   * is given more than once is added. */
  struct SymmetricTriplets : SymmetricElements
  {
    void add(const unsigned int row, const unsigned int column, const double value)
    {
      if (row == column)
        SymmetricElements::add({row}, {value});
      else
        SymmetricElements::add({row, column}, {0., value, 0.});
    }

    /** Adds a dense matrix at those of its rows and columns that are not held. */
    template <typename Dof>
    void add(const std::vector<Dof> &dofs, const dealii::FullMatrix<double> &matrix,
             const std::vector<bool> &held)
    {
      std::vector<unsigned int> rows;
      std::vector<double> lower;
      for (unsigned int column = 0; column < dofs.size(); ++column)
        if (!held[dofs[column]])
        {
          rows.push_back(dofs[column]);
          for (unsigned int row = column; row < dofs.size(); ++row)
            if (!held[dofs[row]])
              lower.push_back(matrix(row, column));
        }
      if (!rows.empty())
        SymmetricElements::add(rows, lower);
    }
  };
} // namespace ringmotor::tests
