// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/declared_entries.h>
#include <ringmotor/parameters/prm_file.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace ringmotor
{
  /**
   * Passes assignments of one origin (a file, or the command line) to @p prm, whose actions write
   * to the variables that were declared.
   *
   * @throws UserError for an entry that is not @p declared or is given twice, and for a value that
   * is not allowed.
   */
  void assign_all(const std::vector<PrmFile::Assignment> &assignments,
                  const DeclaredEntries &declared, dealii::ParameterHandler &prm);

  /** What is probably wrong with a rejected @p value, and what is allowed, to be written behind the
   * name of its entry. */
  std::string explain_refusal(const std::string &value, const DeclaredEntries::Entry &entry);

  /**
   * Looks for numbers implausible for any motor, which suggest units other than SI.
   * @throws UserError
   */
  void check_plausible(const std::vector<PrmFile::Assignment> &assignments,
                       const DeclaredEntries &declared);
} // namespace ringmotor
