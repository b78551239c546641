// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/elements/sum_of_squares.h>

namespace ringmotor
{
  using namespace dealii;

  void SumOfSquares::fill(FullMatrix<double> &matrix) const
  {
    FullMatrix<double> weighted(rows);
    for (unsigned int row = 0; row < rows.m(); ++row)
      for (unsigned int i = 0; i < rows.n(); ++i)
        weighted(row, i) *= weights[row];
    rows.Tmmult(matrix, weighted);
  }

  std::vector<double> SumOfSquares::products(const std::vector<Vector<double>> &fields) const
  {
    std::vector<double> sums;
    Vector<double> at_points(rows.m());
    for (const Vector<double> &field : fields)
    {
      rows.vmult(at_points, field);
      double sum = 0.;
      for (unsigned int row = 0; row < rows.m(); ++row)
        sum += weights[row] * at_points[row] * at_points[row];
      sums.push_back(sum);
    }
    return sums;
  }
} // namespace ringmotor
