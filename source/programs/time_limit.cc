// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/programs/run_results.h>
#include <ringmotor/programs/time_limit.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>

namespace ringmotor
{
  TimeLimit::TimeLimit(const std::string &program, const Parameters &parameters,
                       const std::string &advice)
  {
    if (parameters.accuracy.time_limit &&
        dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      watch = std::thread(&TimeLimit::wait, this, *parameters.accuracy.time_limit, program,
                          failure_file(program, parameters), advice);
  }

  TimeLimit::~TimeLimit()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex);
      is_over = true;
    }
    changed.notify_one();
    if (watch.joinable())
      watch.join();
  }

  void TimeLimit::wait(const double seconds, const std::string &program,
                       const std::string &noted_in, const std::string &advice)
  {
    constexpr double most = 1e8; // three years: a clock counts to 300
    std::unique_lock<std::mutex> lock(mutex);
    if (changed.wait_for(lock, std::chrono::duration<double>(std::min(seconds, most)),
                         [this] { return is_over; }))
      return;
    const std::string message =
        "Accuracy/Time limit = " + short_text(seconds) + " s exceeded; " + advice;
    note_failure(noted_in, message);
    std::cerr << program << ": " << message << std::endl;
    std::_Exit(2); // the main thread computes, and cannot be asked
  }
} // namespace ringmotor
