// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/sensitivity/sensitivities.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** `sensitivities.csv`: a row for each entry, see doc/files.md.
   * @throws UserError if writing fails */
  void write_sensitivities(const std::string &path, const std::vector<Sensitivity> &all);

  /** The same as a table for people, a line each: the head, then the entries that change a quantity
   * most, no more than @p n_most, then those that are not known, with the reason. */
  std::vector<std::string> describe(const std::vector<Sensitivity> &all, const unsigned int n_most);
} // namespace ringmotor
