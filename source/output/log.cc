// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/log.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <malloc.h>
#include <sstream>
#include <unistd.h>

namespace ringmotor
{
  namespace
  {
    double seconds_since(const std::chrono::steady_clock::time_point then)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
    }

    std::string stamp(const double seconds)
    {
      std::ostringstream text;
      text << '[' << std::fixed << std::setprecision(2) << std::setw(7) << seconds << " s] ";
      return text.str();
    }
  } // namespace

  Log::Log(const bool is_root_rank) : Log(is_root_rank, std::cout, ::isatty(STDOUT_FILENO) == 1) {}

  Log::Log(const bool is_root_rank, std::ostream &out, const bool is_terminal)
      : is_root_rank(is_root_rank), out(out), is_terminal(is_terminal),
        start(std::chrono::steady_clock::now()), task_start(start)
  {
  }

  void Log::line(const std::string &text)
  {
    if (!is_root_rank)
      return;
    wipe_progress();
    // Flushed, so that a run that writes to a pipe can be followed.
    out << stamp(seconds_since(start)) << text << std::endl;
  }

  void Log::progress(const std::string &new_task, const double fraction)
  {
    if (!is_root_rank || !is_terminal)
      return;

    wipe_progress();
    if (new_task != task)
    {
      task       = new_task;
      task_start = std::chrono::steady_clock::now();
    }
    if (fraction >= 1.)
    {
      task.clear();
      return;
    }

    out << stamp(seconds_since(start)) << task << ": " << std::lround(100. * fraction) << " %";
    if (fraction > 0.)
      out << ", " << std::lround(seconds_since(task_start) * (1. - fraction) / fraction)
          << " s left";
    out << std::flush;
  }

  void Log::wipe_progress()
  {
    // carriage return and "erase to the end of the line"
    if (!task.empty())
      out << "\r\033[K" << std::flush;
  }

  Phases::Scope::Scope(Phases &phases, const std::string &name)
      : phases(phases), index(phases.index_of(name)), start(std::chrono::steady_clock::now())
  {
  }

  Phases::Scope::~Scope()
  {
    phases.entries[index].second += seconds_since(start);
  }

  std::size_t Phases::index_of(const std::string &name)
  {
    const auto entry        = std::find_if(entries.begin(), entries.end(),
                                           [&name](const auto &known) { return known.first == name; });
    const std::size_t index = entry - entries.begin();
    if (entry == entries.end())
      entries.emplace_back(name, 0.);
    return index;
  }

  double peak_memory_MB()
  {
    dealii::Utilities::System::MemoryStats stats;
    dealii::Utilities::System::get_memory_stats(stats);
    const double bytes_per_kB = 1024.; // the kernel's "kB"
    return stats.VmHWM * bytes_per_kB / 1e6;
  }

  void forget_peak_memory()
  {
    malloc_trim(0);                                // what is free already is not part of what comes
    std::ofstream("/proc/self/clear_refs") << "5"; // proc(5)
  }
} // namespace ringmotor
