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
  void zpotrf_(const char *triangle, const int *n, std::complex<double> *a, const int *lda,
               int *info);
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
      return pairs;
    }

    /** L of A = L L^H in the lower triangle, zero above. */
    std::vector<Complex> cholesky_factor(std::vector<Complex> a, const int n)
    {
      constexpr double rounding = 1e-10; // of the largest diagonal entry
      double largest            = 0.;
      for (int i = 0; i < n; ++i)
        largest = std::max(largest, a[i * (n + 1)].real());
      for (int i = 0; i < n; ++i)
        a[i * (n + 1)] += rounding * largest;
      int info = 0;
      zpotrf_("L", &n, a.data(), &n, &info);
      if (info != 0)
        throw ComputationError(
            "a Hermitian matrix that must not have negative eigenvalues has some");
      for (int column = 1; column < n; ++column)
        std::fill_n(a.begin() + column * n, column, Complex());
      return a;
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
  } // namespace

  std::vector<Complex> contained_columns(const unsigned int n_rows, std::vector<Complex> a,
                                         std::vector<Complex> y)
  {
    if (y.empty())
      return y;
    const int n = n_rows, n_y = y.size() / n_rows;
    const std::vector<Complex> l = cholesky_factor(std::move(a), n);
    std::vector<Complex> z       = y; // L^-1 Y
    int info                     = 0;
    ztrtrs_("L", "N", "N", &n, &n_y, l.data(), &n, z.data(), &n, &info);
    Assert(info == 0, dealii::ExcInternalError()); // a factor of Cholesky is regular
    // Of the singular values above one the vectors on either side do, those on the smaller one.
    const bool by_columns = n_y < n;
    const Pairs pairs     = by_columns ? eigenpairs_above(1., product("C", "N", n, z, n, z), n_y)
                                       : eigenpairs_above(1., product("N", "C", n, z, n, z), n);
    if (pairs.values.empty())
      return y;
    const int n_vectors = by_columns ? n_y : n;
    std::vector<Complex> scaled(pairs.vectors.begin(),
                                pairs.vectors.begin() + pairs.values.size() * n_vectors);
    const std::vector<Complex> vectors = scaled;
    for (std::size_t i = 0; i < scaled.size(); ++i)
      scaled[i] *= 1. - 1. / std::sqrt(pairs.values[i / n_vectors]);
    const std::vector<Complex> excess = // Y - Y'
        by_columns ? product("N", "C", n, product("N", "N", n, y, n_y, vectors), n_y, scaled)
                   : product("N", "N", n, product("N", "N", n, l, n, scaled), pairs.values.size(),
                             product("C", "N", n, vectors, n, z));
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] -= excess[i];
    return y;
  }
} // namespace ringmotor
