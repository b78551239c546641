// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/rotor_modes.h>

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
    /** @param modes of this rotor, on their mesh of @p level; @param n_harmonics of the wave that
     * are looked at */
    LipAmplification(const Parameters &parameters, const LipModes &modes, const unsigned int level,
                     const unsigned int n_harmonics);

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

    /** Roughly, by how much inertia changes speeds and torques, relatively: by the share of the
     * lip's static motion under teeth that press on a quarter of each wave that it changes, each
     * harmonic at most as a whole; of that a third, as found on motors with a soft and with a stiff
     * rotor.
     * @param angular_frequency rad/s, of the wave */
    double rough_effect(const double angular_frequency) const;

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
