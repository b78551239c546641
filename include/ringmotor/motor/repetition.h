// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace ringmotor
{
  /** What turns around the ring beside the teeth themselves. */
  struct RingPattern
  {
    unsigned int n_waves    = 0; ///< of the travelling wave
    unsigned int n_teeth    = 0; ///< of the whole ring
    unsigned int warp_waves = 0; ///< of a warp that stands still; 0: the ring is even
  };

  /** How the settled motion of a ring repeats itself in time. */
  struct Repetition
  {
    /** Into how many equal parts a period of the wave falls, after each of which all is the same,
     * turned by some teeth. */
    unsigned int n_parts;
    unsigned int n_teeth; ///< of the turn after one part
  };

  /** A turn by m teeth maps N teeth with a warp of p waves onto themselves if N divides m p; the
   * wave of n waves is there n m / N of a period later. */
  Repetition repetition_of(const RingPattern &pattern);
} // namespace ringmotor
