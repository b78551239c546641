// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/wave/mode_content.h>

#include <vector>

namespace ringmotor
{
  /** The wave that has most of the kinetic energy in a mode of a whole ring. */
  struct RingContent
  {
    unsigned int n_waves = 0;  ///< around the ring
    double share         = 0.; ///< of the kinetic energy that this wave has as a motion of rigid
                               ///< cross-sections
    double antinode = 0.; ///< rad, the smallest angle from the x axis at which the axial motion is
                          ///< largest, in the plane the radial one, or the rotation of torsion
    ModeContent content;  ///< of that wave
  };

  /**
   * Finds the waves in modes of a whole ring: their projections, in the kinetic energy, on motions
   * of rigid cross-sections times cos(n theta) and sin(n theta).
   * @param most_waves the largest n
   */
  std::vector<RingContent> ring_contents(const CyclicSector &ring, std::vector<Mode> modes,
                                         const unsigned int most_waves);
} // namespace ringmotor
