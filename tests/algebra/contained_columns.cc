// SPDX-License-Identifier: LGPL-2.1-or-later

// The nearest columns whose squares a Hermitian matrix contains: by hand where all is diagonal, and
// for random ones by the eigenvalues that remain and by a condition that only the nearest ones
// meet.

#include "support/hermitian.h"

#include <ringmotor/algebra/contained_columns.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  using Complex = std::complex<double>;

  /** Column by column. */
  struct Matrix
  {
    unsigned int n_rows;
    std::vector<Complex> entries;

    unsigned int n_columns() const { return entries.size() / n_rows; }
    Complex operator()(const unsigned int i, const unsigned int j) const
    {
      return entries[j * n_rows + i];
    }

    /** Adds @p factor times M M^H. */
    void add_square(const double factor, const Matrix &m)
    {
      for (unsigned int i = 0; i < n_rows; ++i)
        for (unsigned int j = 0; j < n_rows; ++j)
          for (unsigned int r = 0; r < m.n_columns(); ++r)
            entries[j * n_rows + i] += factor * m(i, r) * std::conj(m(j, r));
    }
  };

  /** Entries up to @p size in each part. */
  Matrix random_matrix(std::mt19937 &random, const unsigned int n_rows,
                       const unsigned int n_columns, const double size)
  {
    const auto number = [&] { return size * (2. * random() / random.max() - 1.); };
    Matrix matrix{n_rows, {}};
    for (unsigned int i = 0; i < n_rows * n_columns; ++i)
    {
      const double real = number();
      matrix.entries.emplace_back(real, number());
    }
    return matrix;
  }

  std::vector<double> eigenvalues(const Matrix &hermitian)
  {
    return hermitian_eigenvalues(hermitian.n_rows, hermitian.entries);
  }
} // namespace

TEST(ColumnsContained, OfADiagonalMatrix)
{
  const Complex i(0., 1.);
  // diag(1, 9, 1) does not contain diag(4, 1, 1/4): the first column is halved.
  const std::vector<Complex> y{2. * i, 0., 0., 0., 1., 0., 0., 0., 0.5},
      expected{i, 0., 0., 0., 1., 0., 0., 0., 0.5};
  const std::vector<Complex> found =
      ContainedColumns(3, {1., 0., 0., 0., 9., 0., 0., 0., 1.}).nearest_to(y);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t j = 0; j < expected.size(); ++j)
    EXPECT_LT(std::abs(found[j] - expected[j]), 1e-12) << j;
}

TEST(ColumnsContained, LeaveNoNegativeEigenvalue)
{
  std::mt19937 random;
  constexpr unsigned int n = 7;
  for (const unsigned int rank : {n, 4u})
    for (const unsigned int n_y : {2u, 6u, 7u, 12u}) // fewer than rows, and more
      for (const double size : {0.05, 0.5, 3.})
      {
        Matrix a{n, std::vector<Complex>(n * n)};
        a.add_square(1., random_matrix(random, n, rank, 1.));
        const double largest = eigenvalues(a).back();
        const Matrix y       = random_matrix(random, n, n_y, size);
        const Matrix contained{n, ContainedColumns(n, a.entries).nearest_to(y.entries)};
        const auto residual_of = [&](const Matrix &columns)
        {
          Matrix residual = a;
          residual.add_square(-1., columns);
          return eigenvalues(residual);
        };
        EXPECT_GT(residual_of(contained).front(), -1e-12 * largest) << rank << ", " << n_y;
        // What is contained stays as it is.
        if (residual_of(y).front() > 0.)
        {
          EXPECT_EQ(contained.entries, y.entries);
        }
      }
}

TEST(ColumnsContained, AreTheNearest)
{
  // To a set of singular values of at most one the nearest F of Y is the one for which no other F'
  // has a larger Re tr F'^H (Y - F): that maximum is the sum of the singular values of Y - F.
  std::mt19937 random;
  constexpr unsigned int n = 5;
  for (const unsigned int n_y : {3u, 5u, 9u})
  {
    const Matrix y = random_matrix(random, n, n_y, 1.);
    Matrix unit{n, std::vector<Complex>(n * n)};
    for (unsigned int i = 0; i < n; ++i)
      unit.entries[i * (n + 1)] = 1.;
    const std::vector<Complex> found = ContainedColumns(n, unit.entries).nearest_to(y.entries);
    Matrix rest                      = y, square{n, std::vector<Complex>(n * n)};
    double product                   = 0.;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      rest.entries[i] -= found[i];
      product += (std::conj(found[i]) * rest.entries[i]).real();
    }
    square.add_square(1., rest);
    double singular_values = 0.;
    for (const double value : eigenvalues(square))
      singular_values += std::sqrt(std::max(0., value));
    EXPECT_GT(product, 0.1);
    EXPECT_NEAR(product, singular_values, 1e-6 * product) << n_y;
  }
}

TEST(ColumnsContained, LieInTheRangeOfASingularMatrix)
{
  // Of diag(4, 0) and of [1, 1; 1, 1], with columns outside of the range
  const auto expect = [](const std::vector<Complex> &a, const std::vector<Complex> &y,
                         const std::vector<Complex> &expected)
  {
    const std::vector<Complex> found = ContainedColumns(2, a).nearest_to(y);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_LT(std::abs(found[i] - expected[i]), 1e-12) << i;
  };
  expect({4., 0., 0., 0.}, {1., 0.01}, {1., 0.});
  expect({4., 0., 0., 0.}, {3., 0.01}, {2., 0.});
  expect({1., 1., 1., 1.}, {0.5, 0.5}, {0.5, 0.5});
  expect({1., 1., 1., 1.}, {2., 2.}, {1., 1.});
  expect({0., 0., 0., 0.}, {1., 1.}, {0., 0.});
}
