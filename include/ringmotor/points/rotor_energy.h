// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/repetition.h>
#include <ringmotor/points/contact_fields.h>

#include <vector>

namespace ringmotor
{
  /**
   * The frequency, as a multiple of the wave's, at which the component with @p k waves around the
   * ring varies at a fixed place of the rotor: n m + p l = k (mod N) with the smallest |m| + |l|, n
   * waves, p waves of the warp, N teeth. In the steady state (no warp) this is exact: each
   * component rotates with the wave. With a warp it is the lowest order in which wave and warp
   * generate the component.
   * @return |m|; also 0 if no m and l generate it
   */
  unsigned int time_harmonic(const RingPattern &pattern, const unsigned int k);

  /**
   * Strain energy (J) of the whole rotor, by the multiple of the wave's frequency at which it
   * varies, averaged over time samples: half the work of contact forces on the rotor's
   * displacements, by components around the ring. The static part (0) is left out, and so are the
   * modes of a rotor with inertia, see OperatingPoint::modal_damping.
   * @param first_sample from which the average is taken
   */
  std::vector<double> rotor_energies(const ContactFields &fields, const RingPattern &pattern,
                                     const unsigned int first_sample = 0);

  /**
   * Power (W) lost inside the rotor per unit of its loss factor. A component with energy E in a
   * wave of angular frequency m omega loses 2 m omega E: like two standing waves a quarter of a
   * period apart, each with the peak energy E.
   */
  double power_per_loss_factor(const std::vector<double> &energies, const double angular_frequency);
} // namespace ringmotor
