// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/blas.h>
#include <ringmotor/algebra/contained_columns.h>
#include <ringmotor/parameters/errors.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

extern "C"
{
  void zpstrf_(const char *triangle, const int *n, std::complex<double> *a, const int *lda,
               int *pivots, int *rank, const double *tolerance, double *work, int *info);
  void ztrtrs_(const char *triangle, const char *transpose, const char *diagonal, const int *n,
               const int *n_columns, const std::complex<double> *a, const int *lda,
               std::complex<double> *b, const int *ldb, int *info);
  void zheevr_(const char *job, const char *range, const char *triangle, const int *n,
               std::complex<double> *a, const int *lda, const double *lowest, const double *highest,
               const int *first, const int *last, const double *tolerance, int *n_found,
               double *values, std::complex<double> *vectors, const int *ldz, int *support,
               std::complex<double> *work, const int *n_work, double *real_work,
               const int *n_real_work, int *integer_work, const int *n_integer_work, int *info);
}

namespace ringmotor
{
  namespace
  {
    using Complex = std::complex<double>;

    struct Pairs
    {
      std::vector<double> values;
      std::vector<Complex> vectors; ///< one after the other
    };

    /** The eigenpairs of a Hermitian matrix whose eigenvalues are above @p lowest. */
    Pairs eigenpairs_above(const double lowest, std::vector<Complex> matrix, const int n)
    {
      const double highest = std::numeric_limits<double>::max(), tolerance = 0.;
      const int unused = 1, n_work = 64 * n, n_real_work = 24 * n, n_integer_work = 10 * n;
      Pairs pairs{std::vector<double>(n), std::vector<Complex>(matrix.size())};
      std::vector<Complex> work(n_work);
      std::vector<double> real_work(n_real_work);
      std::vector<int> integer_work(n_integer_work), support(2 * n);
      int n_found = 0, info = 0;
      zheevr_("V", "V", "L", &n, matrix.data(), &n, &lowest, &highest, &unused, &unused, &tolerance,
              &n_found, pairs.values.data(), pairs.vectors.data(), &n, support.data(), work.data(),
              &n_work, real_work.data(), &n_real_work, integer_work.data(), &n_integer_work, &info);
      if (info != 0)
        throw ComputationError("LAPACK found no eigenpairs of a Hermitian matrix");
      pairs.values.resize(n_found);
      pairs.vectors.resize(static_cast<std::size_t>(n_found) * n);
      return pairs;
    }

    /** a b, a^H b or a b^H; matrices with these numbers of rows, "N" or "C" says which. */
    std::vector<Complex> product(const char *of_a, const char *of_b, const int rows_a,
                                 const std::vector<Complex> &a, const int rows_b,
                                 const std::vector<Complex> &b)
    {
      const int columns_a = a.size() / rows_a, columns_b = b.size() / rows_b;
      const int rows = *of_a == 'N' ? rows_a : columns_a, inner = *of_a == 'N' ? columns_a : rows_a,
                columns = *of_b == 'N' ? columns_b : rows_b;
      const Complex one(1.), zero;
      std::vector<Complex> result(static_cast<std::size_t>(rows) * columns);
      zgemm_(of_a, of_b, &rows, &columns, &inner, &one, a.data(), &rows_a, b.data(), &rows_b, &zero,
             result.data(), &rows);
      return result;
    }

    /** Reduces the singular values of a matrix with @p n rows that are above one to one.
     * @return whether there were any */
    bool clip_singular_values(std::vector<Complex> &z, const int n)
    {
      // Z Z^H and Z^H Z have the same eigenvalues, the squares of the singular values: the smaller
      // one is taken.
      const int n_columns   = z.size() / n;
      const bool by_columns = n_columns < n;
      const int n_vectors   = by_columns ? n_columns : n;
      const Pairs pairs     = eigenpairs_above(
              1., by_columns ? product("C", "N", n, z, n, z) : product("N", "C", n, z, n, z),
              n_vectors);
      const int n_found = pairs.values.size();
      if (n_found == 0)
        return false;
      std::vector<Complex> scaled = pairs.vectors;
      for (std::size_t i = 0; i < scaled.size(); ++i)
        scaled[i] *= 1. - 1. / std::sqrt(pairs.values[i / n_vectors]);
      const std::vector<Complex> excess =
          by_columns
              ? product("N", "C", n, product("N", "N", n, z, n_vectors, pairs.vectors), n_vectors,
                        scaled)
              : product("N", "N", n, scaled, n_found, product("C", "N", n, pairs.vectors, n, z));
      for (std::size_t i = 0; i < z.size(); ++i)
        z[i] -= excess[i];
      return true;
    }
  } // namespace

  ContainedColumns::ContainedColumns(const unsigned int n_rows, std::vector<Complex> a)
      : n_rows(n_rows)
  {
    constexpr double rounding = 1e-8; // of the largest diagonal entry
    const int n               = n_rows;
    double largest            = 0.;
    for (int i = 0; i < n; ++i)
      largest = std::max(largest, a[i * (n + 1)].real());
    const double tolerance = rounding * largest;
    std::vector<int> order(n);
    std::vector<double> work(2 * n);
    int rank = 0, info = 0;
    // It stops where what is left is not positive: zero up to rounding.
    zpstrf_("L", &n, a.data(), &n, order.data(), &rank, &tolerance, work.data(), &info);
    Assert(info >= 0, dealii::ExcInternalError());
    upper.resize(static_cast<std::size_t>(rank) * rank);
    l.resize(static_cast<std::size_t>(rank) * n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= std::min(i, rank - 1); ++j)
      {
        l[j * n + order[i] - 1] = a[j * n + i];
        if (i < rank)
          upper[j * rank + i] = a[j * n + i];
      }
    for (int i = 0; i < rank; ++i)
      pivots.push_back(order[i] - 1);
  }

  std::vector<Complex> ContainedColumns::nearest_to(const std::vector<Complex> &y) const
  {
    const int rank = pivots.size(), n_columns = y.size() / n_rows;
    if (rank == 0)
      return std::vector<Complex>(y.size());
    std::vector<Complex> z; // Y = L Z in the rows of pivots
    for (int column = 0; column < n_columns; ++column)
      for (const int row : pivots)
        z.push_back(y[column * n_rows + row]);
    int info = 0;
    ztrtrs_("L", "N", "N", &rank, &n_columns, upper.data(), &rank, z.data(), &rank, &info);
    Assert(info == 0, dealii::ExcInternalError());
    const bool is_regular = pivots.size() == n_rows;
    return clip_singular_values(z, rank) || !is_regular ? product("N", "N", n_rows, l, rank, z) : y;
  }
} // namespace ringmotor
