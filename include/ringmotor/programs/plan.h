// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/programs/command_line.h>
#include <ringmotor/programs/process.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace ringmotor
{
  /** What a process is asked for, when everything that can be known in advance has been checked. */
  struct Plan
  {
    Parameters parameters;
    std::vector<Program> programs; ///< that are to run, in this order
  };

  /**
   * Reads the parameters and checks them for all programs that are to run: those from the first one
   * asked for, and where the modes of the rotor or of a tooth are asked for, which have no wave for
   * the others, that one alone.
   * @param further overrides behind those of the command line
   * @param[out] speaker who finds a mistake: the process or, in its check, a program
   * @throws UserError
   */
  Plan make_plan(const Process &process, const CommandLine &line, std::string &speaker,
                 const std::vector<std::string> &further = {});

  /** Answers `--check=json`: prints an object with the folder of the results, the programs that are
   * to run, the files that the parameters name, the identity of the motor and all entries, see
   * doc/files.md. */
  void print_as_json(std::ostream &out, const Plan &plan);

  /**
   * Answers `--check=lines`: reads lines, each a JSON list of further overrides `Section/Entry =
   * value`, and prints for each a line with the identity of that motor, or with what is wrong with
   * it, before it reads the next one.
   */
  void answer_lines(std::istream &in, std::ostream &out, const Process &process,
                    const CommandLine &line);
} // namespace ringmotor
