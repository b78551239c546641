// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/log.h>
#include <ringmotor/output/summary.h>
#include <ringmotor/parameters/parameters.h>

#include <string>

namespace ringmotor
{
  /** The folder in which a program writes its results, with a slash at its end. */
  std::string results_folder(const std::string &program, const Parameters &parameters);

  /** The file that tells why a program has failed, as long as it has not run again. */
  std::string failure_file(const std::string &program, const Parameters &parameters);

  /** Makes the folder of a program's results, and removes from it what @p ours, a regular
   * expression for names of files, says an earlier run has left: results of two runs side by side
   * would tell a wrong story. */
  void prepare_results(const std::string &folder, const std::string &ours);

  /** Stores the parameters of a run with the version that ran. */
  void write_used_prm(const std::string &path, const std::string &program,
                      const Parameters &parameters);

  /** Lets no uncertified number out.
   * @throws ComputationError that names the first check which does not hold */
  void require_certified(const Summary &summary);

  /** A summary with all that any program can say of its run. */
  Summary begin_summary(const std::string &program, const Parameters &parameters,
                        const Phases &phases);
} // namespace ringmotor
