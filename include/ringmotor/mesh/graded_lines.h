// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace ringmotor
{
  /**
   * Mesh lines at growing distances from a re-entrant edge, including 0 and @p length (m): the
   * first cell has width @p first, each further one is about three times as wide as the one before.
   */
  std::vector<double> graded_lines(const double length, const double first);

  /** The widths of the cells between lines in ascending order. */
  std::vector<double> widths(const std::vector<double> &lines);
} // namespace ringmotor
