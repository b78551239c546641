// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/ring_modes.h>

namespace ringmotor
{
  /**
   * Replaces the modes of each set by the nearest ones whose static motions the static compliance C
   * of a ring contains:
   * the residual compliance C - sum motion motion^H / omega^2, which has no mass, has no negative
   * eigenvalue for any wave. With one, contact would be ill-posed: short pulses of force would gain
   * energy. Modes of a finer mesh than that of C exceed it under forces that vary from node to
   * node; under smooth forces they change by some per cent at most. The modes of all bodies are
   * taken together: those of the rotor may take over some of the motion of teeth. Frequencies do
   * not change, nor modes that C does not contain, that respond as at rest or that have damping
   * without inertia. See ContainedColumns.
   */
  void contain_modes(const std::vector<RingModes *> &sets, const RingCompliance &compliance,
                     const RingDynamics &dynamics);
} // namespace ringmotor
