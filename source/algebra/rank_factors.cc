// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/rank_factors.h>

#include <algorithm>
#include <cmath>
#include <vector>

extern "C"
{
  void dgeqp3_(const int *m, const int *n, double *a, const int *lda, int *jpvt, double *tau,
               double *work, const int *lwork, int *info);
  void dorgqr_(const int *m, const int *n, const int *k, double *a, const int *lda,
               const double *tau, double *work, const int *lwork, int *info);
}

namespace ringmotor
{
  RankFactors::RankFactors(const dealii::FullMatrix<double> &matrix, const double tolerance)
  {
    const int m = static_cast<int>(matrix.m()), n = static_cast<int>(matrix.n()),
              n_steps = std::min(m, n), n_work = 64 * (m + n);
    if (n_steps == 0)
      return;
    std::vector<double> entries(static_cast<std::size_t>(m) * n), tau(n_steps), work(n_work);
    const auto entry = [&](const std::size_t i, const std::size_t j) -> double &
    { return entries[j * m + i]; };
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j)
        entry(i, j) = matrix(i, j);
    std::vector<int> pivots(n, 0);
    int info = 0;
    dgeqp3_(&m, &n, entries.data(), &m, pivots.data(), tau.data(), work.data(), &n_work, &info);
    int rank = 0;
    while (rank < n_steps && std::abs(entry(rank, rank)) > tolerance * std::abs(entry(0, 0)))
      ++rank;
    if (rank == 0)
      return;
    weights.reinit(rank, n);
    for (int i = 0; i < rank; ++i)
      for (int j = i; j < n; ++j)
        weights(i, pivots[j] - 1) = entry(i, j);
    dorgqr_(&m, &rank, &rank, entries.data(), &m, tau.data(), work.data(), &n_work, &info);
    columns.reinit(m, rank);
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < rank; ++j)
        columns(i, j) = entry(i, j);
  }
} // namespace ringmotor
