// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/programs/program.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** What one process does: a program, or several, each on the results of those before it. */
  struct Process
  {
    /** A program alone. */
    Process(Program program)
        : name(program.name), purpose(program.purpose), programs{std::move(program)}
    {
    }
    /** @param programs in the order in which they run */
    Process(std::string name, std::string purpose, std::vector<Program> programs)
        : name(std::move(name)), purpose(std::move(purpose)), programs(std::move(programs))
    {
    }

    std::string name, purpose;
    std::vector<Program> programs;
  };
} // namespace ringmotor
