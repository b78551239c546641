// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/programs/process.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** The words behind the name of a program. */
  struct CommandLine
  {
    std::string file;
    std::vector<std::string> overrides; ///< `Section/Entry = value`
    std::optional<std::string> from;    ///< the program to begin with; none: the first one
    std::optional<std::string> done;    ///< file for the names of the programs that have run
    bool check = false, study = false, resume = false, clear = false, sensitivities = false,
         help = false, version = false;
    /** Form of what `--check` or `--help` print: "json", "lines", "sections"; empty for people. */
    std::string form;
  };

  /**
   * Reads `FILE.prm [--set 'Section/Sub/Entry = value']... [--output DIR]` and the options that the
   * programs of a process have.
   * @throws UserError if there is no file, more than one, or an option that is unknown, lacks its
   * value, is not available or cannot be combined with another one
   */
  CommandLine read_command_line(int argc, char **argv, const Process &process);

  /** Prints the usage with all options, and all entries with their meaning. */
  void print_help(std::ostream &out, const Process &process);
} // namespace ringmotor
