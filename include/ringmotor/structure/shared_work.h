// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

#include <functional>
#include <vector>

// Work shared by ranks. Utilities::MPI::all_gather() would compress what it sends, which takes
// longer than some of the work; broadcast() does not.

namespace ringmotor
{
  /** What each of the ranks has, by rank, on all of them. Collective.
   * @param Item can be serialised with Boost */
  template <typename Item>
  std::vector<Item> of_all_ranks(const Item &mine, const MPI_Comm ranks)
  {
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(ranks);
    std::vector<Item> all(n_ranks);
    for (unsigned int rank = 0; rank < n_ranks; ++rank)
      all[rank] = dealii::Utilities::MPI::broadcast(ranks, mine, rank);
    return all;
  }

  /**
   * The results of all tasks, each of which one of the ranks carries out, on every rank.
   * Collective: all ranks must have the same tasks, none of which may communicate.
   * @param Result can be serialised with Boost
   */
  template <typename Result>
  std::vector<Result> shared_work(const std::vector<std::function<Result()>> &tasks,
                                  const MPI_Comm ranks)
  {
    const unsigned int rank    = dealii::Utilities::MPI::this_mpi_process(ranks),
                       n_ranks = dealii::Utilities::MPI::n_mpi_processes(ranks);
    std::vector<Result> results(tasks.size());
    for (std::size_t i = rank; i < tasks.size(); i += n_ranks)
      results[i] = tasks[i]();
    if (n_ranks > 1) // nothing to be packed and unpacked otherwise
      for (std::size_t i = 0; i < tasks.size(); ++i)
        results[i] = dealii::Utilities::MPI::broadcast(ranks, results[i], i % n_ranks);
    return results;
  }
} // namespace ringmotor
