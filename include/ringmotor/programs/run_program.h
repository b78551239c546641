// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <functional>
#include <string>

namespace ringmotor
{
  /**
   * To be called before MPI starts: a program started without mpirun needs no network, and not
   * looking for one saves a third of a second; nor does it need a folder for its session, which
   * it would share with others that run at the same time.
   */
  void spare_the_network_search();

  /** A program: what its main() hands to run_program(). */
  struct Program
  {
    std::string name, purpose;
    /** What checks the parameters for contradictions, and what does the work. */
    std::function<void(const Parameters &)> check, run;
    /** The option `--study`, alone or with `--resume`. */
    std::function<void(const Parameters &, bool resumes)> study = {};
    /** The options `--resume` and `--clear`. Options that a program does not have are refused. */
    std::function<void(const Parameters &)> resume = {}, clear = {};
  };

  /**
   * Everything a program's main() does around its work: selects a fast BLAS kernel, starts MPI,
   * reads the command line `FILE.prm [--set 'Section/Sub/Entry = value']... [--output DIR]
   * [--check] [--study] [--resume] [--clear] [--help] [--version]` and the parameters, checks them
   * and, in a folder that it locks, does the work; turns errors into one line on standard error and
   * an exit status: 0 done and certified, 1 the user's mistake, 2 a computation that failed. The
   * message of an error in the work is kept in the folder of the case, see failure_file().
   */
  int run_program(int argc, char **argv, const Program &program);
} // namespace ringmotor
