// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <cmath>

namespace ringmotor
{
  /** Three whole numbers that positions within ten nanometres of each other have in common. */
  using PlaceKey = std::array<long long, 3>;

  /** The key of a position in m. */
  inline PlaceKey key_of(const dealii::Point<3> &place)
  {
    // Shifted so that no round length lies between two whole numbers
    PlaceKey key;
    for (unsigned int d = 0; d < 3; ++d)
      key[d] = std::llround(place[d] * 1e8 + 0.2718);
    return key;
  }
} // namespace ringmotor
