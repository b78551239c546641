// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/blas.h>
#include <ringmotor/algebra/dense_product.h>

namespace ringmotor
{
  using dealii::FullMatrix;

  void add_product(const double factor, const Transposed transposed, const std::vector<double> &a,
                   const std::size_t n_inner, const std::vector<double> &b,
                   std::vector<double> &result)
  {
    if (result.empty() || n_inner == 0)
      return;
    constexpr int few_columns = 4;
    const double one          = 1.;
    const char *op            = transposed == Transposed::yes ? "T" : "N";
    const int inner = static_cast<int>(n_inner), columns = static_cast<int>(b.size() / n_inner),
              rows = static_cast<int>(result.size()) / columns, step = 1,
              a_rows    = transposed == Transposed::yes ? inner : rows,
              a_columns = transposed == Transposed::yes ? rows : inner;
    if (columns > few_columns)
      dgemm_(op, "N", &rows, &columns, &inner, &factor, a.data(), &a_rows, b.data(), &inner, &one,
             result.data(), &rows);
    else
      for (std::size_t column = 0; column < static_cast<std::size_t>(columns); ++column)
        dgemv_(op, &a_rows, &a_columns, &factor, a.data(), &a_rows, b.data() + column * inner,
               &step, &one, result.data() + column * rows, &step);
  }

  FullMatrix<double> product(const FullMatrix<double> &a, const FullMatrix<double> &b,
                             const Transposed transposed_a)
  {
    const bool is_transposed = transposed_a == Transposed::yes;
    FullMatrix<double> result(is_transposed ? a.n() : a.m(), b.n());
    if (!a.empty() && !b.empty())
      is_transposed ? a.Tmmult(result, b) : a.mmult(result, b);
    return result;
  }

  FullMatrix<double> transposed(const FullMatrix<double> &matrix)
  {
    FullMatrix<double> result(matrix.n(), matrix.m());
    result.copy_transposed(matrix);
    return result;
  }

  std::vector<FullMatrix<double>> transposed(const std::vector<FullMatrix<double>> &matrices)
  {
    std::vector<FullMatrix<double>> result;
    for (const FullMatrix<double> &matrix : matrices)
      result.push_back(transposed(matrix));
    return result;
  }
} // namespace ringmotor
