// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <functional>
#include <string>

namespace ringmotor
{
  /**
   * To be called before MPI starts: a program started without mpirun needs no network, and not
   * looking for one saves a third of a second.
   */
  void spare_the_network_search();

  /**
   * Everything a program's main() does around its work: sees to a fast BLAS, starts MPI, reads the
   * command line `FILE.prm [--set 'Section/Sub/Entry = value']... [--output DIR] [--study]
   * [--resume] [--help]
   * [--version]` and the parameters, calls @p check and then @p run or, with `--study`, @p study
   * or, with `--resume`, @p resume with them (a program without @p resume refuses the option), and
   * turns errors into one line on standard error and an exit status: 0 done and certified, 1 the
   * user's mistake, 2 a computation that failed.
   */
  int run_program(int argc, char **argv, const std::string &name, const std::string &purpose,
                  const std::function<void(const Parameters &)> &check,
                  const std::function<void(const Parameters &)> &run,
                  const std::function<void(const Parameters &)> &study,
                  const std::function<void(const Parameters &)> &resume = {});
} // namespace ringmotor
