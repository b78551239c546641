// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/motor_model.h>
#include <ringmotor/structure/modes.h>

namespace ringmotor
{
  /**
   * By how much what @p model puts on the stator (target plates, felt) shifts the frequency of
   * @p mode, relatively, as Rayleigh's quotient says for the mode as it is: (K/omega^2 - M) / 2 of
   * what is added by M of the body. Negative where mass prevails. Collective.
   */
  double frequency_shift(const CyclicSector &sector, const Mode &mode, const MotorModel &model);

  /** Puts it on the mesh of a stator. */
  void add_to_stator(const MotorModel &model, SectorMesh &mesh);
} // namespace ringmotor
