// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

#include <type_traits>
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

  /** Whether this rank carries out a task, if ranks take turns. */
  inline bool is_my_turn(const std::size_t task, const MPI_Comm ranks)
  {
    return task % dealii::Utilities::MPI::n_mpi_processes(ranks) ==
           dealii::Utilities::MPI::this_mpi_process(ranks);
  }

  /** How ranks have shared their work so far, in seconds of the processor; of one rank, what others
   * could share. */
  struct SharedSeconds
  {
    std::vector<double> by_rank; ///< for the tasks of each
    /** For the tasks of the rank that had most, added up over all times that work was shared: with
     * a core for each rank, so long do they work together. */
    double longest = 0.;

    static const SharedSeconds &so_far();
  };

  /** Tasks 0, 1, ..., each handed out to the rank that asks first. */
  class TaskQueue
  {
  public:
    /** Collective. */
    TaskQueue(const std::size_t n_tasks, const MPI_Comm ranks);

    /** Takes the next task for this rank; false if none is left. */
    bool take(std::size_t &task);
    /** To be called when none is left: the rank that took each task. Collective. */
    std::vector<unsigned int> finish();

  private:
    const MPI_Comm ranks;
    const bool is_shared;
    std::vector<unsigned int> taker; ///< by task, of those that this rank took
    MPI_Win window = MPI_WIN_NULL;   ///< to the next task, on rank 0; not freed after an error, as
                                     ///< other ranks would have to join
    int next = 0;                    ///< task, if there is one rank
    double begin;                    ///< seconds of the processor
  };

  /**
   * What @p work gives for each of some items, each of which one of the ranks works on, on every
   * rank. A rank takes the next item when it has finished one: those that take long should come
   * first. Collective: all ranks must have the same items, and @p work must not communicate.
   * @param work `Result work(const Item &)`; results can be serialised with Boost
   */
  template <typename Item, typename Work>
  auto shared_work(const std::vector<Item> &items, const Work &work, const MPI_Comm ranks)
  {
    std::vector<std::invoke_result_t<Work, const Item &>> results(items.size());
    TaskQueue queue(items.size(), ranks);
    for (std::size_t i; queue.take(i);)
      results[i] = work(items[i]);
    const std::vector<unsigned int> taker = queue.finish();
    if (dealii::Utilities::MPI::n_mpi_processes(ranks) > 1) // nothing to be packed otherwise
      for (std::size_t i = 0; i < items.size(); ++i)
        results[i] = dealii::Utilities::MPI::broadcast(ranks, results[i], taker[i]);
    return results;
  }
} // namespace ringmotor
