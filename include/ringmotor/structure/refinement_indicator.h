// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sheets.h>
#include <ringmotor/structure/sector_elements.h>

namespace ringmotor
{
  /**
   * For each motion and each sheet, U.M U times the decrease of the eigenvalue if the polynomial
   * degree across the sheet went to infinity. For an eigenvalue, primal and dual solution coincide,
   * and the contribution of a part of the solution is its strain energy: the indicator is
   * goal-oriented for the frequency. In each cell the strain energies of the parts of highest and
   * second highest degree across the sheet give the rate at which they fall with the degree; the
   * series is summed. frequency_estimate() contains the factor to the true error.
   */
  std::vector<std::vector<double>>
  sheet_indicators(const SectorElements &sector, const Sheets &sheets,
                   const std::vector<const SectorMotion *> &motions);
} // namespace ringmotor
