// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/solve_matrix.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/sparse_direct.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Whether a matrix is factorised the faster without its zeros. */
    bool is_large_and_sparse(const FullMatrix<double> &matrix)
    {
      // Few rows take milliseconds anyway, and LAPACK keeps zeros exact that UMFPACK's scaling
      // rounds.
      constexpr unsigned int few = 600;
      constexpr double sparse = 0.3; // that of six moments; the order of elimination has its price
      if (matrix.m() < few)
        return false;
      const double *entries = &matrix(0, 0);
      const auto n_zeros    = std::count(entries, entries + matrix.n_elements(), 0.);
      return matrix.n_elements() - n_zeros <= sparse * matrix.n_elements();
    }
  } // namespace

  bool solve_matrix(const FullMatrix<double> &matrix, Vector<double> &solution)
  {
    try
    {
      if (!is_large_and_sparse(matrix))
      {
        LAPACKFullMatrix<double> factors(matrix.m());
        factors = matrix;
        factors.compute_lu_factorization();
        factors.solve(solution);
        return true;
      }
      SparsityPattern pattern;
      pattern.copy_from(matrix);
      SparseMatrix<double> without_zeros(pattern);
      without_zeros.copy_from(matrix);
      SparseDirectUMFPACK().solve(without_zeros, solution);
      return true;
    }
    catch (const LACExceptions::ExcSingular &)
    {
      return false;
    }
    catch (const SparseDirectUMFPACK::ExcUMFPACKError &)
    {
      return false;
    }
  }
} // namespace ringmotor
