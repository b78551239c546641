// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/study_files.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/programs/interruption.h>
#include <ringmotor/programs/run_results.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /**
   * Computes the settings of a study, keeping each as soon as it is known, logs what they show and
   * writes `study.csv` and `study.prm`. Collective.
   *
   * @param study with settings(), the key() of a setting, and compute() and compare() for their
   * rows, such as BodyStudy
   * @param folder of the results of @p program, which exists; ends in a slash
   * @param resumes whether rows of an interrupted study are reused
   */
  template <class Study>
  void run_study(const std::string &folder, const std::string &program,
                 const Parameters &parameters, Study &study, const bool resumes, Log &log)
  {
    const bool is_root_rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    const std::string kept  = folder + "kept/study/";
    StudyKeep keep(kept, resumes, log, MPI_COMM_WORLD);
    if (is_root_rank)
      tell_when_interrupted(program + ": interrupted; the settings studied so far are kept in " +
                            kept + ": continue with --study --resume");
    log.line("study of " + std::to_string(study.settings().size()) + " settings");
    std::vector<StudyRow> rows;
    for (const auto &setting : study.settings())
      rows.push_back(keep.row(study.key(setting), [&] { return study.compute(setting); }));
    keep.report();
    const WorkPrecision compared = study.compare(rows);
    for (const std::string &line : describe(compared))
      log.line(line);
    if (is_root_rank)
    {
      write_used_prm(folder + "study.prm", program, parameters);
      write_study(folder + "study.csv", compared);
    }
    log.line("study in " + folder + "study.csv");
  }
} // namespace ringmotor
