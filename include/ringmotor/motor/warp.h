// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace ringmotor
{
  /** How high the tops of the teeth stand at rest over those of an even ring; by default not at
   * all.
   */
  struct Warp
  {
    double amplitude     = 0.; ///< m
    unsigned int n_waves = 0;  ///< around the ring

    /** The height (m) at an angle (rad) from the centre of tooth 0. A tooth's top follows it, with
     * its slope: there is no step from one tooth to the next. */
    double height(const double theta) const { return amplitude * std::cos(n_waves * theta); }
  };
} // namespace ringmotor
