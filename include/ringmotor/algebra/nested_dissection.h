// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/sparse_ldlt.h>

#include <vector>

namespace ringmotor
{
  /**
   * The order in which the variables of a matrix are eliminated by nested dissection (METIS): for
   * each of @p size variables its place, from 1. On the mesh of a whole ring factors take as much
   * time and memory as with minimum fill, or less: two thirds for the rotor of prm/canon_ring.prm.
   * Variables of the same elements are one node of the graph.
   */
  std::vector<int> nested_dissection(const SymmetricElements &elements, const unsigned int size);
} // namespace ringmotor
