// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/contact_bodies.h>
#include <ringmotor/motor/ring_modes.h>

#include <vector>

namespace ringmotor
{
  /** The discretisation of a tooth for its vibrations at a level of RotorVibration: its modes are
   * wrong where its foot, with singular edges, is coarse. */
  ContactDiscretisation tooth_modes_discretisation(const unsigned int level);

  /** A mode of a body's half sector, at the nodes of its surface over the whole sector. */
  RingMode mode_on_surface(const CyclicSector &sector, const ContactSurface &surface,
                           const std::vector<MirroredNode> &origin, const Mode &mode,
                           const ModePart part);

  /** Where contact points lie on the surface of another mesh of the teeth. */
  std::vector<SurfaceWeights> weights_on(const ContactSurface &surface,
                                         const ContactSurface &tooth_top,
                                         const MortarCoupling &mortar);

  /**
   * The vibrations of a tooth that is clamped at its foot, at points of its top, on a mesh of its
   * own. The motion of the foot is included in the free motion of the top, without contact forces.
   * @param level see RotorVibration
   * @param up_to rad/s, the highest frequency of the forces on it
   * @param tooth_top the surface to which contact points @p mortar belong
   */
  std::vector<RingMode> tooth_modes(const Parameters &parameters, const unsigned int level,
                                    const double up_to, const ContactSurface &tooth_top,
                                    const MortarCoupling &mortar);
} // namespace ringmotor
