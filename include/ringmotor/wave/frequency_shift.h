// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/motor_model.h>
#include <ringmotor/structure/modes.h>

namespace ringmotor
{
  /**
   * The relative shift of the frequency of @p mode by what @p model adds to the stator (target
   * plates, felt), from Rayleigh's quotient of the unchanged mode: (K/omega^2 - M) / 2 of what is
   * added, divided by M of the body. Negative where mass prevails. Collective.
   */
  double frequency_shift(const CyclicSector &sector, const Mode &mode, const MotorModel &model);
} // namespace ringmotor
