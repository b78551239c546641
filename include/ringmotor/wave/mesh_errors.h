// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sheets.h>
#include <ringmotor/structure/modes.h>

#include <vector>

namespace ringmotor
{
  /** For each mode and each sheet of the mesh, the indicator of the relative error of the mode's
   * eigenvalue, see sheet_indicators(); zero for linear elements, which have no part of highest
   * degree to judge the error by. Collective. */
  std::vector<std::vector<double>> relative_indicators(const CyclicSector &sector,
                                                       const Sheets &sheets,
                                                       const std::vector<Mode> &modes);

  /** By sheet, whether it is among those with most of the error per cell that together carry three
   * fifths of it. */
  std::vector<bool> sheets_with_most_error(const SectorMesh &mesh, const Sheets &sheets,
                                           const std::vector<double> &error);
} // namespace ringmotor
