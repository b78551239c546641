// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/wave/ring_search.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** `frequencies.csv` of a whole ring: its modes with their error bars and the wave in each. */
  void write_frequencies(const std::string &path, const std::vector<FoundRingMode> &modes);

  /**
   * Writes the whole ring with its modes as a VTU file of Lagrange cells. Point fields: `mode_1`,
   * `mode_2`, ... (Cartesian vectors, m; their largest displacement is @p amplitude) and
   * `material`.
   *
   * @throw UserError if writing fails
   */
  void write_ring_modes(const std::string &path, const CyclicSector &ring,
                        const std::vector<FoundRingMode> &modes, const double amplitude);
} // namespace ringmotor
