// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace ringmotor
{
  /** The periodic patterns around the ring: teeth, wave and warp. */
  struct RingPattern
  {
    unsigned int n_waves    = 0; ///< of the travelling wave
    unsigned int n_teeth    = 0; ///< of the whole ring
    unsigned int warp_waves = 0; ///< of a warp fixed to the stator; 0: the ring is flat
  };

  /** How the settled motion of a ring repeats itself in time. */
  struct Repetition
  {
    /** Number of equal parts of a period of the wave, after each of which the motion is the same,
     * rotated by some teeth. */
    unsigned int n_parts;
    unsigned int n_teeth; ///< of the rotation after one part
  };

  /** A rotation by m teeth maps N teeth with a warp of p waves onto themselves if N divides m p;
   * the wave of n waves arrives there n m / N of a period later. */
  Repetition repetition_of(const RingPattern &pattern);
} // namespace ringmotor
