// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/types.h>

namespace ringmotor
{
  /** In lists of indices of nodes, unknowns or points: there is none. */
  inline constexpr unsigned int none = dealii::numbers::invalid_unsigned_int;
} // namespace ringmotor
