// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/condensed_motor.h>

#include <array>
#include <memory>

namespace ringmotor
{
  /** The nodal diameter, 0 .. N / 2, of a harmonic of the wave as the teeth sample it. */
  unsigned int nodal_diameter_of_harmonic(const Motor &motor, const unsigned int harmonic);

  /** The motion of the contact points by a wave on the surface of a half sector, real field, then
   * imaginary one; their rotor nodes may belong to neighbouring sectors. @param turn the wave's
   * phase from one sector to the next (rad) */
  std::vector<std::array<std::complex<double>, 3>>
  at_contact_points(const std::vector<double> &half, const std::vector<MirroredNode> &origin,
                    const MortarCoupling &mortar, const double turn);

  /**
   * The modes of the rotor with two nodal diameters and more, on a separate mesh. With fewer nodal
   * diameters the rotor also moves as a whole. In a uniform ring its response to these is static,
   * as it is in the modes that are left out, and only the nodal diameters of low harmonics of the
   * wave matter. A rotor that moves as a whole, see MotorModel, has the modes of all nodal
   * diameters from two on, and in addition the inertia of its rise and its near-rigid modes; its
   * elastic deformation with fewer than two nodal diameters remains static.
   */
  class LipModes
  {
  public:
    /** @param level of the mesh; @param frequency rad/s, of the wave; @param n_harmonics of the wave
     * that may matter */
    LipModes(const Parameters &parameters, const unsigned int level, const double frequency,
             const unsigned int n_harmonics);

    /** The rotor's discretisation for its modes at a level. */
    static ContactDiscretisation discretisation(const unsigned int level);

    /** At the contact points on @p tooth_top. @param lip_turn see ContactDiscretisation */
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

  /** The modes of a rotor at levels of increasing accuracy: in their mesh, in their highest
   * frequency, in the harmonics of the wave whose nodal diameters they have. Computed lazily. */
  class RotorVibration
  {
  public:
    static constexpr unsigned int finest_level = 3;
    /** For tight targets, to begin with. */
    static constexpr unsigned int usual_level = 2;
    /** The modes of teeth are included up to this multiple of the wave's frequency. */
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
