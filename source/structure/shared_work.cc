// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/shared_work.h>

#include <algorithm>
#include <ctime>

namespace ringmotor
{
  using namespace dealii::Utilities::MPI;

  namespace
  {
    double seconds_of_processor()
    {
      return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    }

    SharedSeconds &all_seconds()
    {
      static SharedSeconds seconds{std::vector<double>(n_mpi_processes(MPI_COMM_WORLD), 0.), 0.};
      return seconds;
    }
  } // namespace

  const SharedSeconds &SharedSeconds::so_far()
  {
    return all_seconds();
  }

  TaskQueue::TaskQueue(const std::size_t n_tasks, const MPI_Comm ranks)
      : ranks(ranks), is_shared(n_mpi_processes(ranks) > 1), taker(n_tasks, 0),
        begin(seconds_of_processor())
  {
    if (!is_shared)
      return;
    int *number;
    MPI_Win_allocate(this_mpi_process(ranks) == 0 ? sizeof(int) : 0, sizeof(int), MPI_INFO_NULL,
                     ranks, &number, &window);
    if (this_mpi_process(ranks) == 0)
      *number = 0;
    MPI_Barrier(ranks);
  }

  bool TaskQueue::take(std::size_t &task)
  {
    int taken = next++;
    if (is_shared)
    {
      const int one = 1;
      MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, window);
      MPI_Fetch_and_op(&one, &taken, MPI_INT, 0, 0, MPI_SUM, window);
      MPI_Win_unlock(0, window);
    }
    task               = taken;
    const bool is_left = task < taker.size();
    if (is_left)
      taker[task] = this_mpi_process(ranks);
    return is_left;
  }

  std::vector<unsigned int> TaskQueue::finish()
  {
    const double mine  = seconds_of_processor() - begin;
    SharedSeconds &all = all_seconds();
    if (!is_shared)
    {
      if (all.by_rank.size() == 1)
        all.longest = all.by_rank[0] += mine;
      return taker;
    }
    MPI_Win_free(&window);
    std::vector<double> of_rank(n_mpi_processes(ranks));
    MPI_Allgather(&mine, 1, MPI_DOUBLE, of_rank.data(), 1, MPI_DOUBLE, ranks);
    for (std::size_t rank = 0; rank < of_rank.size(); ++rank)
      all.by_rank[rank] += of_rank[rank];
    all.longest += *std::max_element(of_rank.begin(), of_rank.end());
    std::vector<unsigned int> takers(taker.size());
    max(taker, ranks, takers);
    return takers;
  }
} // namespace ringmotor
