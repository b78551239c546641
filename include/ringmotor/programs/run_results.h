// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/log.h>
#include <ringmotor/output/summary.h>
#include <ringmotor/parameters/parameters.h>

#include <string>

namespace ringmotor
{
  /** `ringmotor 0.1.0 (1455fa2)`. */
  std::string this_version();

  /** The folder in which a program writes its results, with a slash at its end. */
  std::string results_folder(const std::string &program, const Parameters &parameters);

  /** The file that says why a program failed; the next run removes it. */
  std::string failure_file(const std::string &program, const Parameters &parameters);

  /** Keeps the message of an error in that file, for those who look at the results; does nothing
   * with an empty path, or where nothing can be written. */
  void note_failure(const std::string &path, const std::string &message);

  /** Creates the folder of a program's results and removes the files of an earlier run from it,
   * whose names match the regular expression @p ours: results of two runs side by side would be
   * misleading. */
  void prepare_results(const std::string &folder, const std::string &ours);

  /** Stores the parameters of a run with the version that ran. */
  void write_used_prm(const std::string &path, const std::string &program,
                      const Parameters &parameters);

  /** Rejects uncertified results.
   * @throws ComputationError that names the first check that does not hold */
  void require_certified(const Summary &summary);

  /** A summary with the entries that all programs have in common. */
  Summary begin_summary(const std::string &program, const Parameters &parameters,
                        const Phases &phases);
} // namespace ringmotor
