// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sheets.h>
#include <ringmotor/structure/sector_elements.h>

namespace ringmotor
{
  /**
   * For each of some modes and each sheet, how much, times U.M U, the eigenvalue would fall if the
   * polynomial degree across the sheet were raised without end. For an eigenvalue primal and dual
   * solution are the same and what a part of the solution is worth is just its strain energy: the
   * indicator is goal-oriented for the frequency. In each cell the strain energies of the parts of
   * highest and second highest degree across the sheet show how fast they fall from degree to
   * degree; the series is summed. frequency_estimate() knows the factor to the true error.
   */
  std::vector<std::vector<double>>
  sheet_indicators(const SectorElements &sector, const Sheets &sheets,
                   const std::vector<const SectorMotion *> &motions);
} // namespace ringmotor
