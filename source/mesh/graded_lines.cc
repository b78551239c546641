// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/graded_lines.h>
#include <ringmotor/mesh/interface_grading.h>

#include <cmath>

namespace ringmotor
{
  std::vector<double> graded_lines(const double length, const double first, const double ratio,
                                   const double longest)
  {
    std::vector<double> lines{0.};
    // A last cell less than sqrt(ratio) of the one before it would only add a sliver.
    for (double distance = first; distance < length * std::sqrt(ratio); distance /= ratio)
      lines.push_back(distance);
    if (length - lines.back() > longest * length)
      lines.push_back(0.5 * (lines.back() + length));
    lines.push_back(length);
    return lines;
  }

  std::vector<double> power_lines(const double length, const unsigned int n_cells,
                                  const double exponent)
  {
    std::vector<double> lines;
    for (unsigned int i = 0; i <= n_cells; ++i)
      lines.push_back(length * std::pow(i, exponent) / std::pow(n_cells, exponent));
    return lines;
  }

  std::vector<double> widths(const std::vector<double> &lines)
  {
    std::vector<double> widths;
    for (unsigned int i = 1; i < lines.size(); ++i)
      widths.push_back(lines[i] - lines[i - 1]);
    return widths;
  }
} // namespace ringmotor
