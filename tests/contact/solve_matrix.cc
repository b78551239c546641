// SPDX-License-Identifier: LGPL-2.1-or-later

// Linear problems with a solution that was chosen before, of one moment and of many.

#include <ringmotor/contact/solve_matrix.h>

#include <gtest/gtest.h>

using namespace dealii;
using namespace ringmotor;

namespace
{
  /** Full blocks, each tied to the one before, and a last row and column that tie all. */
  FullMatrix<double> ring_of_blocks(const unsigned int n_blocks, const unsigned int n_of_block)
  {
    const unsigned int n = n_blocks * n_of_block;
    FullMatrix<double> matrix(n + 1, n + 1);
    for (unsigned int i = 0; i < n; ++i)
    {
      const unsigned int block = i / n_of_block, before = (block + n_blocks - 1) % n_blocks;
      for (unsigned int j = 0; j < n_of_block; ++j)
      {
        matrix(i, before * n_of_block + j) -= 0.3 / (2. + j);
        matrix(i, block * n_of_block + j) += 1. / (1. + (i % n_of_block) + j);
      }
      matrix(i, i) += 1.;
      matrix(i, n) = matrix(n, i) = 1. + 0.1 * i;
    }
    return matrix;
  }
} // namespace

TEST(SolveMatrix, FindsTheSolutionOfOneMomentAndOfMany)
{
  for (const unsigned int n_blocks : {1u, 2u, 5u, 9u, 18u})
  {
    const FullMatrix<double> matrix = ring_of_blocks(n_blocks, 40);
    Vector<double> expected(matrix.m()), solution(matrix.m());
    for (unsigned int i = 0; i < expected.size(); ++i)
      expected[i] = 1. - 0.01 * i * i;
    matrix.vmult(solution, expected);
    ASSERT_TRUE(solve_matrix(matrix, solution));
    solution -= expected;
    EXPECT_LT(solution.linfty_norm(), 1e-11 * expected.linfty_norm()) << n_blocks << " blocks";
  }
}

TEST(SolveMatrix, SaysThatAMatrixIsSingular)
{
  for (const unsigned int n_blocks : {1u, 18u})
  {
    FullMatrix<double> matrix = ring_of_blocks(n_blocks, 40);
    for (unsigned int j = 0; j < matrix.n(); ++j)
      matrix(3, j) = 0.;
    Vector<double> solution(matrix.m());
    solution = 1.;
    EXPECT_FALSE(solve_matrix(matrix, solution)) << n_blocks << " blocks";
  }
}
