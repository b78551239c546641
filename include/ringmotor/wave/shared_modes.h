// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/modes.h>

#include <map>
#include <vector>

// Nodal diameters shared by ranks of which each has the whole sector.

namespace ringmotor
{
  /** Every n-th of some nodal diameters on n ranks, beginning with this rank's number. */
  std::vector<unsigned int> share_of_rank(const std::vector<unsigned int> &nodal_diameters,
                                          MPI_Comm ranks);

  /** Those of all ranks, on each. Collective. */
  std::map<unsigned int, std::vector<ShiftWindow>>
  gathered(const std::map<unsigned int, std::vector<ShiftWindow>> &mine, MPI_Comm ranks);

  /** Those of all ranks, on each, by nodal diameter; @p sector is the same on all. Collective. */
  std::map<unsigned int, std::vector<Mode>>
  gathered(const std::map<unsigned int, std::vector<Mode>> &mine, const CyclicSector &sector,
           MPI_Comm ranks);
} // namespace ringmotor
