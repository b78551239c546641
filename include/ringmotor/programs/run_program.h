// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/programs/process.h>

namespace ringmotor
{
  /**
   * Everything main() does around the work of one or several programs: selects a fast BLAS kernel,
   * starts MPI, reads the command line (see CommandLine) and the parameters, checks them for all
   * programs before the first one runs and, in a folder that it locks, does the work; turns errors
   * into one line on standard error and an exit status: 0 done and certified, 1 the user's mistake,
   * 2 a computation that failed. The message of an error in the work is kept in the folder of the
   * case, see failure_file(). Programs behind one that fails do not run.
   */
  int run_program(int argc, char **argv, const Process &process);
} // namespace ringmotor
