// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/contact_bodies.h>
#include <ringmotor/motor/ring_modes.h>

#include <vector>

namespace ringmotor
{
  /**
   * The modes of a tooth that is clamped at its foot, at its contact points. The motion of the foot
   * is included in the free motion of the top, without contact forces.
   * @param discretisation of the contact; @param mortar its contact points
   * @param up_to rad/s, highest frequency
   */
  std::vector<RingMode> tooth_modes(const Parameters &parameters,
                                    const ContactDiscretisation &discretisation,
                                    const MortarCoupling &mortar, const double up_to);
} // namespace ringmotor
