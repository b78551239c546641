// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/rotor_modes.h>

#include <vector>

namespace ringmotor
{
  /**
   * The dynamic amplification of the motion of the rotor's lip under pressure that travels around
   * its outer line, relative to a rotor without inertia: shows, before any contact is computed,
   * whether the rotor may be modelled as static. Harmonic m of a wave with n waves has n m waves
   * around the ring and m times the frequency. Undamped: infinite at resonance, negative beyond.
   */
  class LipAmplification
  {
  public:
    /** @param modes of this rotor, on their mesh of @p level; @param n_harmonics of the wave that
     * are considered */
    LipAmplification(const Parameters &parameters, const LipModes &modes, const unsigned int level,
                     const unsigned int n_harmonics);

    unsigned int n_harmonics() const { return harmonics.size(); }
    /** Nodal diameter of a harmonic (1, 2, ...), as the teeth sample it: 0 .. N / 2. */
    unsigned int nodal_diameter(const unsigned int harmonic) const
    {
      return harmonics[harmonic - 1].nodal_diameter;
    }

    /** Ratio of the motions with and without inertia under pressure with the waves of a harmonic
     * and an angular frequency (rad/s); 1 for nodal diameters that move the rotor as a whole, see
     * LipModes. */
    double at(const unsigned int harmonic, const double angular_frequency) const;

    /** A_r/A_n of the outer line of the lip under the pressure of a harmonic at an angular
     * frequency (rad/s), negative if it moves inwards where it is lifted: where it is that of the
     * teeth, see MotorWave, the lip does not rub on them across; 0 for nodal diameters that move
     * the rotor as a whole. */
    double radial_ratio(const unsigned int harmonic, const double angular_frequency) const;

    /** A rough estimate of the relative change of speeds and torques due to inertia: a third, as
     * found on motors with a soft and with a stiff rotor, of the share by which inertia changes the
     * lip's static motion under teeth that press on a quarter of each wave; the change of each
     * harmonic is limited to its static motion.
     * @param angular_frequency rad/s, of the wave */
    double rough_effect(const double angular_frequency) const;

  private:
    struct Harmonic
    {
      unsigned int nodal_diameter;
      double static_motion = 0.;       ///< J, work of the pressure on its static motion
      double static_radial = 0.;       ///< J, that of the same forces if they pointed outwards
      std::vector<double> frequencies; ///< rad/s, of the modes
      std::vector<double> work;        ///< of the pressure on them, squared
      std::vector<double> radial;      ///< this work times that of the forces outwards
    };
    /** What vibration adds to a static motion: of each mode by its share in @p work. */
    static double dynamic(const Harmonic &of, const double static_motion,
                          const std::vector<double> &work, const double angular_frequency);
    std::vector<Harmonic> harmonics;
  };
} // namespace ringmotor
