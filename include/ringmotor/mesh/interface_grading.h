// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace ringmotor
{
  /** How finely two bodies are meshed where they touch. */
  struct InterfaceGrading
  {
    unsigned int n_across = 1;  ///< cells across the lip
    unsigned int n_around = 1;  ///< cells along the half tooth, or along the lip's half pitch
    double exponent       = 2.; ///< of the distances of mesh lines from edges, see power_lines()
  };

  /** Lines of @p n_cells cells, at distances 0 to @p length (m) from a line where stresses are
   * large; the distances grow as the integers to the power of @p exponent: cells shrink towards
   * that line, or are even if it is 1. */
  std::vector<double> power_lines(const double length, const unsigned int n_cells,
                                  const double exponent);
} // namespace ringmotor
