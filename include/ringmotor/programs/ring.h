// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

namespace ringmotor
{
  /** The program `stator` with `Modes/Domain = ring`: modes of a whole ring near a frequency, from
   * a mesh that is refined until the frequencies are as accurate as requested. */
  void run_on_whole_ring(const Parameters &parameters);
} // namespace ringmotor
