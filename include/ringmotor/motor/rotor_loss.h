// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

namespace ringmotor
{
  /** The loss factor of a rotor as a sum over its parts: the loss factor of each, weighted with its
   * share of the elastic energy. */
  struct RotorLossFactor
  {
    double metal = 0., lining = 0., adhesive = 0.;
    bool has_lining = false, has_adhesive = false;

    double sum() const { return metal + lining + adhesive; }
  };

  /**
   * The loss factor of the whole rotor, by parts. With parts of several materials, such as a
   * lining, it is their mean, weighted with the power that each loses per unit of its loss factor
   * under an even pressure on the face in contact that travels with the wave, a quarter of a
   * wavelength long; the strain energies are those of the rotor without inertia. Computing it takes
   * up to a second. Where no such wave bends the rotor, it is the largest of them.
   */
  RotorLossFactor rotor_loss_by_part(const Parameters &parameters);

  /** Its sum. */
  double rotor_loss_factor(const Parameters &parameters);

  /** The largest loss factor of the rotor's parts. */
  double largest_rotor_loss_factor(const Parameters &parameters);
} // namespace ringmotor
