// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

namespace ringmotor
{
  /**
   * The loss factor of the whole rotor. With parts of several materials, such as a lining, it is
   * their mean, weighted with the power that each loses per unit of its loss factor under an even
   * pressure on the face in contact that travels with the wave, a quarter of a wavelength long; the
   * strain energies are those of the rotor without inertia. Computing it takes up to a second.
   */
  double rotor_loss_factor(const Parameters &parameters);

  /** The largest loss factor of the rotor's parts. */
  double largest_rotor_loss_factor(const Parameters &parameters);
} // namespace ringmotor
