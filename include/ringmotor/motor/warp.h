// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace ringmotor
{
  /** The height of the tooth tops at rest above those of a flat ring; zero by default. */
  struct Warp
  {
    double amplitude     = 0.; ///< m
    unsigned int n_waves = 0;  ///< around the ring

    /** The height (m) at an angle (rad) from the centre of tooth 0. The top of a tooth follows it
     * including its slope: there is no step from one tooth to the next. */
    double height(const double theta) const { return amplitude * std::cos(n_waves * theta); }
  };
} // namespace ringmotor
