// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace ringmotor
{
  /**
   * Lines of a mesh at growing distances from a re-entrant edge, 0 and @p length included (m): the
   * first cell is @p first wide, each further one about three times wider than the one before.
   */
  std::vector<double> graded_lines(const double length, const double first);

  /** The widths of the cells between lines in ascending order. */
  std::vector<double> widths(const std::vector<double> &lines);
} // namespace ringmotor
