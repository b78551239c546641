// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/log.h>
#include <ringmotor/results/work_precision.h>

#include <deal.II/base/mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** `study.csv`: one row for each setting, with its relative distance from the best one in each
   * quantity and the quantities for which it is on the Pareto front. */
  void write_study(const std::string &path, const WorkPrecision &study);

  /** What a study shows, in words: for each quantity the cheapest setting for some tolerances, and
   * the price of the next digit. */
  std::vector<std::string> describe(const WorkPrecision &study);

  /**
   * The rows of a study kept in a folder for a run that goes on after an interruption. Rows that
   * are damaged or belong to other parameters, or to another build of the program, are computed
   * again.
   *
   * All members are called on all ranks of @p communicator together.
   */
  class StudyKeep
  {
  public:
    /** Removes the rows of earlier runs unless this run @p resumes.
     * @param folder ends in a slash @throws UserError if the file system refuses */
    StudyKeep(const std::string &folder, const bool resumes, Log &log, MPI_Comm communicator);

    /** A kept row, or one that is computed and kept immediately; logs it.
     * @param key all that the row depends on besides this build of the program */
    StudyRow row(const std::string &key, const std::function<StudyRow()> &compute);

    /** Logs how many rows of a resumed run were available. */
    void report();

  private:
    const std::string folder;
    const bool resumes, is_root_rank;
    Log &log;
    const MPI_Comm communicator;
    unsigned int n_recalled = 0, n_damaged = 0, n_computed = 0;
  };
} // namespace ringmotor
