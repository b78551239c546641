// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <vector>

namespace ringmotor
{
  /**
   * How much farther the lip of a rotor with inertia gives way to pressure that travels around its
   * outer line than that of one without: what tells, before any contact is computed, whether a
   * rotor may be taken as static. Harmonic m of a wave with n waves has n m waves around the ring
   * and m times the frequency. Undamped: infinite at resonance, negative beyond.
   */
  class LipAmplification
  {
  public:
    /** @param n_harmonics of the wave that are looked at
     * @param up_to rad/s, highest frequency of the modes */
    LipAmplification(const Parameters &parameters, const unsigned int n_harmonics,
                     const double up_to);

    unsigned int n_harmonics() const { return harmonics.size(); }
    /** Waves around the ring of a harmonic (1, 2, ...), seen from tooth to tooth: 0 .. N / 2. */
    unsigned int nodal_diameter(const unsigned int harmonic) const
    {
      return harmonics[harmonic - 1].nodal_diameter;
    }

    /** Motion over that without inertia under pressure with the waves of a harmonic that pulses
     * with an angular frequency (rad/s); 1 for the few waves that move the rotor as a whole, see
     * LipModes. */
    double at(const unsigned int harmonic, const double angular_frequency) const;

  private:
    struct Harmonic
    {
      unsigned int nodal_diameter;
      double static_motion = 0.;       ///< J, work of the pressure on its own static motion
      std::vector<double> frequencies; ///< rad/s, of the modes
      std::vector<double> work;        ///< of the pressure on them, squared
    };
    std::vector<Harmonic> harmonics;
  };
} // namespace ringmotor
