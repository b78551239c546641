// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>
#include <ringmotor/structure/modes.h>

namespace ringmotor
{
  /** The target plates as bars along the outer edges of the tooth tops. */
  BarSection target_plates(const Parameters &parameters);

  /**
   * By how much @p plates shift the frequency of @p mode, relatively, as Rayleigh's quotient says
   * for the mode as it is: (K/omega^2 - M) / 2 of the plates by M of the body. Negative where mass
   * prevails.
   */
  double target_plate_shift(const CyclicSector &sector, const Mode &mode, const BarSection &plates);
} // namespace ringmotor
