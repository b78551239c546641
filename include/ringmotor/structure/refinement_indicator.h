// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sheets.h>
#include <ringmotor/structure/cyclic_sector.h>

namespace ringmotor
{
  /**
   * For each sheet, the strain energy (relative to the mode's) of the part of @p mode that is of
   * the highest polynomial degree across the sheet. For an eigenfrequency primal and dual solution
   * are the same, and what the eigenvalue would change without that part is just this energy: the
   * indicator is goal-oriented for the frequency.
   */
  std::vector<double> sheet_indicators(const CyclicSector &sector, const Sheets &sheets,
                                       const ComplexField &mode);
} // namespace ringmotor
