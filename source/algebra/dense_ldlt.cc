// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/dense_ldlt.h>
#include <ringmotor/parameters/errors.h>

#include <string>
#include <utility>

extern "C"
{
  void dsytrf_(const char *uplo, const int *n, double *a, const int *lda, int *ipiv, double *work,
               const int *lwork, int *info);
  void dsytrs_(const char *uplo, const int *n, const int *nrhs, const double *a, const int *lda,
               const int *ipiv, double *b, const int *ldb, int *info);
  void dsytrs2_(const char *uplo, const int *n, const int *nrhs, double *a, const int *lda,
                const int *ipiv, double *b, const int *ldb, double *work, int *info);
}

namespace ringmotor
{
  namespace
  {
    constexpr char lower = 'L';
  }

  void DenseLDLT::factorise(const unsigned int n_rows, std::vector<double> matrix)
  {
    size    = static_cast<int>(n_rows);
    factors = std::move(matrix);
    pivots.resize(n_rows);
    const int block = 64, n_work = block * size;
    std::vector<double> work(n_work);
    int info = 0;
    if (size > 0)
      dsytrf_(&lower, &size, factors.data(), &size, pivots.data(), work.data(), &n_work, &info);
    if (info != 0)
      throw ComputationError("a dense symmetric matrix of " + std::to_string(size) +
                             " rows is singular (LAPACK dsytrf, code " + std::to_string(info) +
                             ")");
  }

  unsigned int DenseLDLT::n_negative() const
  {
    unsigned int count = 0;
    for (int i = 0; i < size; ++i)
      if (pivots[i] < 0) // a block of two rows: one eigenvalue of either sign
      {
        ++count;
        ++i;
      }
      else
        count += factors[static_cast<std::size_t>(i) * size + i] < 0.;
    return count;
  }

  void DenseLDLT::solve(std::vector<double> &right_hand_sides)
  {
    if (size == 0)
      return;
    const int n_right_hand_sides = static_cast<int>(right_hand_sides.size() / size);
    constexpr int few = 4; // for which the preparation of dsytrs2 takes longer than it saves
    int info          = 0;
    if (n_right_hand_sides <= few)
    {
      dsytrs_(&lower, &size, &n_right_hand_sides, factors.data(), &size, pivots.data(),
              right_hand_sides.data(), &size, &info);
      return;
    }
    std::vector<double> work(size);
    dsytrs2_(&lower, &size, &n_right_hand_sides, factors.data(), &size, pivots.data(),
             right_hand_sides.data(), &size, work.data(), &info);
  }
} // namespace ringmotor
