// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

// Parameters for those who have no reader of parameter files: scripts and other programs.

namespace ringmotor
{
  /** `Section/Sub/Entry` and the text of its value, in the order of a parameter file. */
  using Entries = std::vector<std::pair<std::string, std::string>>;

  /** All entries, but without those of Parameters::not_given. */
  Entries entries_of(const Parameters &parameters);

  /** Writes a commented parameter file with all entries and their default values, which those that
   * a file has to give do not have. */
  void print_template(std::ostream &out);

  /** Writes what is declared as JSON: nested objects for sections, and for each entry its default
   * value (empty if a file has to give it), documentation and pattern in words, in the order of a
   * parameter file. */
  void print_declarations(std::ostream &out);
} // namespace ringmotor
