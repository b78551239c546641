// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/repetition.h>
#include <ringmotor/quantities/contact_fields.h>

#include <vector>

namespace ringmotor
{
  /**
   * The frequency, as a multiple of the wave's, at which the part with @p k waves around the ring
   * changes at a place of the rotor: n m + p l = k (mod N) with the smallest |m| + |l|, n waves, p
   * waves of the warp, N teeth. In the steady state (no warp) that is exact: each part turns with
   * the wave. With a warp it is the lowest order in which wave and warp make the part.
   * @return |m|; 0 as well if no m and l make it
   */
  unsigned int time_harmonic(const RingPattern &pattern, const unsigned int k);

  /**
   * Strain energy (J) of the rotor, of the whole ring, by the multiple of the wave's frequency at
   * which it changes, mean over samples: half the work of contact forces on the rotor's
   * displacements, part by part around the ring. What stands still (0) is left out, and so are the
   * modes of a rotor with inertia, see OperatingPoint::modal_damping.
   * @param first_sample from which the mean is taken
   */
  std::vector<double> rotor_energies(const ContactFields &fields, const RingPattern &pattern,
                                     const unsigned int first_sample = 0);

  /**
   * Power (W) that the rotor loses inside for each unit of its loss factor. A part with energy E in
   * a wave that turns at m omega loses 2 m omega E: like two standing waves a quarter of a period
   * apart, each with the peak energy E.
   */
  double power_per_loss_factor(const std::vector<double> &energies, const double angular_frequency);
} // namespace ringmotor
