// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace ringmotor
{
  /**
   * Mesh lines at growing distances from a re-entrant edge, including 0 and @p length (m): the
   * first cell has width @p first; the distances grow by a factor of 1 / @p ratio. No
   * cell is longer than @p longest times @p length.
   */
  std::vector<double> graded_lines(const double length, const double first,
                                   const double ratio = 0.3, const double longest = 0.6);

  /** The widths of the cells between lines in ascending order. */
  std::vector<double> widths(const std::vector<double> &lines);
} // namespace ringmotor
