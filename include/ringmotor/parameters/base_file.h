// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/prm_file.h>

#include <string>
#include <vector>

// A parameter file may hold only what differs from another one, which it names with a line
// `set Base file = PATH` outside of all subsections. That one may have a base of its own.

namespace ringmotor
{
  /** The text of a parameter file. @throws UserError if it cannot be read */
  std::string text_of_prm(const std::string &path);

  /**
   * @p file with those that it is based on, itself last: each takes precedence over those before
   * it. The path of a base is relative to the folder of the file that names it.
   *
   * @throws UserError for a base that cannot be read or has broken syntax, and for one that leads
   * back to itself.
   */
  std::vector<PrmFile> with_bases(const PrmFile &file);
} // namespace ringmotor
