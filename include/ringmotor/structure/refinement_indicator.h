// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sheets.h>
#include <ringmotor/structure/cyclic_sector.h>

namespace ringmotor
{
  /**
   * For each mode and each sheet, how much the eigenvalue would fall, relatively, if the polynomial
   * degree across the sheet were raised without end. For an eigenvalue primal and dual solution are
   * the same and what a part of the solution is worth is just its strain energy: the indicator is
   * goal-oriented for the frequency. In each cell the strain energies of the parts of highest and
   * second highest degree across the sheet show how fast they fall from degree to degree; the
   * series is summed. frequency_estimate() knows the factor to the true error.
   */
  std::vector<std::vector<double>> sheet_indicators(const CyclicSector &sector,
                                                    const Sheets &sheets,
                                                    const std::vector<const ComplexField *> &modes);
} // namespace ringmotor
