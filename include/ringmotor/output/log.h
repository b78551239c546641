// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace ringmotor
{
  /** The run's messages to its user: plain lines with the time since the start of the log. */
  class Log
  {
  public:
    /** Writes to standard output. @param is_root_rank true on MPI rank 0; the other ranks stay
     * silent */
    explicit Log(bool is_root_rank);

    /** Writes to any stream. @param is_terminal whether a line can be overwritten */
    Log(bool is_root_rank, std::ostream &out, bool is_terminal);

    /** Prints `[  1.23 s] text`. */
    void line(const std::string &text);

    /**
     * On a terminal, shows how much of a task is done and how many seconds are left, on a line that
     * the next output overwrites; elsewhere prints nothing.
     *
     * @param fraction of the task that is done, 0..1; the task begins with its first call and
     * ends with 1
     */
    void progress(const std::string &task, double fraction);

  private:
    using Clock = std::chrono::steady_clock;

    void wipe_progress();

    const bool is_root_rank;
    std::ostream &out;
    const bool is_terminal;
    const Clock::time_point start;
    std::string task; ///< whose progress is on the screen, empty if none
    Clock::time_point task_start;
  };

  /** Wall-clock seconds per named phase, in the order of their first use. */
  class Phases
  {
  public:
    /** Adds the time of its lifetime to a phase. */
    class Scope
    {
    public:
      Scope(Phases &phases, const std::string &name);
      Scope(const Scope &)            = delete;
      Scope &operator=(const Scope &) = delete;
      ~Scope();

    private:
      Phases &phases;
      const std::size_t index;
      const std::chrono::steady_clock::time_point start;
    };

    /** `const auto scope = phases.measure("mesh");` counts until the end of the block. */
    [[nodiscard]] Scope measure(const std::string &name) { return Scope(*this, name); }

    const std::vector<std::pair<std::string, double>> &seconds() const { return entries; }

  private:
    std::size_t index_of(const std::string &name);

    std::vector<std::pair<std::string, double>> entries;
  };

  /** Largest resident memory of this process so far, in MB (1e6 bytes). */
  double peak_memory_MB();

  /** Begins anew: the largest memory is that from now on, where the system allows that. */
  void forget_peak_memory();
} // namespace ringmotor
