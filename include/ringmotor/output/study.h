// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/text.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** The setting of a study (with members `seconds` and `largest_error`, relative) with the least
   * seconds among those whose error bars are all within @p tolerance; null if there is none. */
  template <class Row>
  const Row *cheapest(const std::vector<Row> &rows, const double tolerance)
  {
    const Row *found = nullptr;
    for (const Row &row : rows)
      if (row.largest_error <= tolerance && (found == nullptr || row.seconds < found->seconds))
        found = &row;
    return found;
  }

  /** `cheapest for 1.0e-03: degree 3, refinement 1, 0.52 s`. @p name describes the setting of a
   * row. */
  template <class Row, class Name>
  std::string describe_cheapest(const std::vector<Row> &rows, const double tolerance,
                                const Name &name)
  {
    if (const Row *row = cheapest(rows, tolerance))
      return "cheapest for " + scientific(tolerance) + ": " + name(*row) + ", " +
             text(row->seconds, 2) + " s";
    return "no setting of the study reaches " + scientific(tolerance);
  }
} // namespace ringmotor
