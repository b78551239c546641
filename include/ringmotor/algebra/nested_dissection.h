// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/sparse_ldlt.h>

#include <vector>

namespace ringmotor
{
  /**
   * The order in which the variables of a matrix are eliminated by nested dissection (METIS): for
   * each of @p size variables its place, from 1. On large meshes, such as that of a whole ring, it
   * takes far fewer operations than minimum fill. Variables of the same elements are one node of
   * the graph.
   */
  std::vector<int> nested_dissection(const SymmetricElements &elements, const unsigned int size);
} // namespace ringmotor
