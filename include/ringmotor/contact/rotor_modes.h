// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/condensed_motor.h>

namespace ringmotor
{
  /** How a wave on the surface of a half sector, real field, then imaginary one, moves the contact
   * points, whose rotor nodes may be of neighbouring sectors. @param turn the wave's phase from one
   * sector to the next (rad) */
  std::vector<std::array<std::complex<double>, 3>>
  at_contact_points(const std::vector<double> &half, const std::vector<MirroredNode> &origin,
                    const MortarCoupling &mortar, const double turn);

  /**
   * The modes of the rotor as the contact points of @p tooth_top see them, with two nodal diameters
   * and more, up to the highest frequency that @p discretisation says. With fewer the rotor moves
   * as a whole, too: there it follows its loads at once, which in a uniform ring change no faster
   * than the modes that are left out.
   *
   * Nodal diameters of which the wave has harmonics up to twice that frequency only; of a warped
   * ring, all.
   */
  RingModes rotor_modes(const Parameters &parameters, const ContactSurface &tooth_top,
                        const StatorWave &wave, const ContactDiscretisation &discretisation);
} // namespace ringmotor
