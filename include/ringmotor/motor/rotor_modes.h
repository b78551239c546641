// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/condensed_motor.h>

#include <array>
#include <memory>

namespace ringmotor
{
  /** The nodal diameter, 0 .. N / 2, that a harmonic of the wave has as the teeth see it. */
  unsigned int nodal_diameter_of_harmonic(const Motor &motor, const unsigned int harmonic);

  /** How a wave on the surface of a half sector, real field, then imaginary one, moves the contact
   * points, whose rotor nodes may be of neighbouring sectors. @param turn the wave's phase from one
   * sector to the next (rad) */
  std::vector<std::array<std::complex<double>, 3>>
  at_contact_points(const std::vector<double> &half, const std::vector<MirroredNode> &origin,
                    const MortarCoupling &mortar, const double turn);

  /**
   * The modes of the rotor on a mesh of their own, with two nodal diameters and more. With fewer
   * the rotor moves as a whole, too. In a uniform ring it follows its loads there at once, which
   * change no faster than the modes that are left out, and only nodal diameters matter that low
   * harmonics of the wave have. A rotor that moves as a whole, see MotorModel, has the modes of all
   * nodal diameters from two on, and beside them inertia of its rise and its near-rigid motions,
   * about which its elastic deformation with less than two nodal diameters is static.
   */
  class LipModes
  {
  public:
    /** @param level of the mesh; @param up_to rad/s, highest frequency; @param n_harmonics of the
     * wave that may matter */
    LipModes(const Parameters &parameters, const unsigned int level, const double up_to,
             const unsigned int n_harmonics);

    /** The rotor's mesh of a level for its modes. */
    static ContactDiscretisation discretisation(const unsigned int level);

    /** As the contact points on @p tooth_top see them. @param lip_turn see ContactDiscretisation */
    RingModes at(const ContactSurface &tooth_top, const double lip_turn) const;

    struct LipMode
    {
      double angular_frequency;
      std::vector<double> motion; ///< of the half sector's lip, real field, then imaginary one
    };
    const std::vector<LipMode> &of_diameter(const unsigned int k) const { return modes[k]; }

  private:
    const unsigned int n_teeth;
    SectorSurface lip;
    std::vector<std::vector<LipMode>> modes; ///< by nodal diameter
  };

  /** The modes of a rotor at levels that get finer: in their mesh, in their highest frequency, in
   * the harmonics of the wave whose nodal diameters they have. Computed when they are asked for. */
  class RotorVibration
  {
  public:
    static constexpr unsigned int finest_level = 2;
    /** Modes of bodies up to so many times the wave's frequency take part at the finest level. */
    static constexpr double highest_harmonic = 12.;

    /** @param frequency rad/s, of the wave */
    RotorVibration(const Parameters &parameters, const double frequency);

    const LipModes &level(const unsigned int level) const;

  private:
    Parameters parameters;
    double frequency;
    mutable std::array<std::shared_ptr<const LipModes>, finest_level + 1> levels;
  };
} // namespace ringmotor
