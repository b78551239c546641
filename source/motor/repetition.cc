// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/repetition.h>

#include <numeric>

namespace ringmotor
{
  Repetition repetition_of(const RingPattern &pattern)
  {
    const unsigned int n_teeth = pattern.n_teeth,
                       of_warp = n_teeth / std::gcd(n_teeth, pattern.warp_waves),
                       n_parts = n_teeth / std::gcd(n_teeth, pattern.n_waves * of_warp);
    unsigned int turn          = of_warp;
    while (pattern.n_waves * turn % n_teeth != n_teeth / n_parts % n_teeth)
      turn += of_warp;
    return {n_parts, turn};
  }
} // namespace ringmotor
