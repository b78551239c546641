// SPDX-License-Identifier: LGPL-2.1-or-later

// The nearest columns whose squares a Hermitian matrix contains: by hand where all is diagonal, and
// for random matrices by the eigenvalues that remain and by the best contraction known otherwise.

#include <ringmotor/algebra/contained_columns.h>
#include <ringmotor/parameters/errors.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace ringmotor;

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

  Matrix random_matrix(const unsigned int n_rows, const unsigned int n_columns, const double size)
  {
    static std::mt19937 random;
    std::normal_distribution<double> normal(0., size);
    Matrix matrix{n_rows, std::vector<Complex>(n_rows * n_columns)};
    for (Complex &entry : matrix.entries)
      entry = {normal(random), normal(random)};
    return matrix;
  }

  /** In ascending order. */
  std::vector<double> eigenvalues(const Matrix &hermitian)
  {
    const unsigned int n = hermitian.n_rows;
    dealii::LAPACKFullMatrix<double> real(2 * n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        real(i, j) = real(n + i, n + j) = hermitian(i, j).real();
        real(n + i, j)                  = hermitian(i, j).imag();
        real(i, n + j)                  = -hermitian(i, j).imag();
      }
    dealii::Vector<double> doubled;
    dealii::FullMatrix<double> vectors;
    real.compute_eigenvalues_symmetric(-1e9, 1e9, 0., doubled, vectors);
    std::vector<double> values;
    for (unsigned int i = 0; i < n; ++i)
      values.push_back(doubled[2 * i]);
    return values;
  }
} // namespace

TEST(ContainedColumns, OfADiagonalMatrix)
{
  const Complex i(0., 1.);
  // diag(1, 9, 1) does not contain diag(4, 1, 1/4): the first column is halved.
  const std::vector<Complex> y{2. * i, 0., 0., 0., 1., 0., 0., 0., 0.5},
      expected{i, 0., 0., 0., 1., 0., 0., 0., 0.5};
  const std::vector<Complex> found = contained_columns(3, {1., 0., 0., 0., 9., 0., 0., 0., 1.}, y);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t j = 0; j < expected.size(); ++j)
    EXPECT_LT(std::abs(found[j] - expected[j]), 1e-9) << j;
}

TEST(ContainedColumns, LeaveNoNegativeEigenvalue)
{
  constexpr unsigned int n = 7;
  for (const unsigned int n_y : {2u, 6u, 7u, 12u}) // fewer than rows, and more
    for (const double size : {0.05, 0.5, 2.})
    {
      Matrix a{n, std::vector<Complex>(n * n)};
      a.add_square(1., random_matrix(n, n + 2, 1.));
      const Matrix y  = random_matrix(n, n_y, size);
      Matrix residual = a;
      residual.add_square(-1., y);
      const std::vector<double> before = eigenvalues(residual);
      const Matrix contained{n, contained_columns(n, a.entries, y.entries)};
      residual = a;
      residual.add_square(-1., contained);
      const std::vector<double> after = eigenvalues(residual);
      EXPECT_GT(after.front(), -1e-8 * after.back());
      // As many directions are left without residual as had a negative one, and no others change.
      const unsigned int n_negative = std::count_if(before.begin(), before.end(),
                                                    [](const double value) { return value < 0.; });
      for (unsigned int r = 0; r < n; ++r)
        EXPECT_EQ(std::abs(after[r]) < 1e-8 * after.back(), r < n_negative) << n_y << ", " << size;
      if (n_negative == 0)
      {
        EXPECT_EQ(contained.entries, y.entries);
      }
    }
}

TEST(ContainedColumns, AreTheNearest)
{
  // In the norm of A no contained columns on the way to some other ones are nearer.
  constexpr unsigned int n = 5, n_y = 4;
  const Matrix y = random_matrix(n, n_y, 1.);
  Matrix unit{n, std::vector<Complex>(n * n)};
  for (unsigned int i = 0; i < n; ++i)
    unit.entries[i * (n + 1)] = 1.;
  const std::vector<Complex> found = contained_columns(n, unit.entries, y.entries);
  const auto distance              = [&](const std::vector<Complex> &columns)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < columns.size(); ++i)
      sum += std::norm(columns[i] - y.entries[i]);
    return std::sqrt(sum);
  };
  for (unsigned int trial = 0; trial < 20; ++trial)
  {
    // Contained, like all on the way: both have singular values of at most one.
    const std::vector<Complex> other =
        contained_columns(n, unit.entries, random_matrix(n, n_y, 1.).entries);
    for (const double step : {1e-3, 0.1, 1.})
    {
      std::vector<Complex> between = found;
      for (std::size_t i = 0; i < between.size(); ++i)
        between[i] += step * (other[i] - found[i]);
      EXPECT_GE(distance(between), distance(found) * (1. - 1e-9));
    }
  }
}

TEST(ContainedColumns, OfAMatrixWithNegativeEigenvaluesAreRefused)
{
  EXPECT_THROW(contained_columns(2, {1., 0., 0., -1.}, {1., 0.}), ComputationError);
}
