// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_surface.h>
#include <ringmotor/mesh/interface_grading.h>
#include <ringmotor/mesh/rotor_sector.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/structure/modes.h>

#include <array>
#include <complex>
#include <functional>
#include <vector>

namespace ringmotor
{
  /** The complex displacement amplitude of the stator's wave (m; r, theta, z components) at a point
   * of a surface of tooth 0. */
  using WaveMotion = std::function<std::array<std::complex<double>, 3>(const dealii::Point<3> &)>;

  /** The meshes and the degree of the finite elements of the bodies in contact. */
  struct ContactDiscretisation
  {
    unsigned int degree = 2;
    InterfaceGrading tooth{2, 1};
    InterfaceGrading lip{2, 1};
    RotorGrading rotor;
    double lip_turn = 0.; ///< rad, of the lip's mesh against that of the teeth

    static constexpr unsigned int finest_level = 4;
    /**
     * Discretisations 0 to #finest_level, of increasing accuracy; how they cut the cells of a body
     * that is read from a file tell StatorShape::contact_tooth() and RotorShape::contact_sector().
     * The bodies touch in a band a few micrometres wide at the lip's outer edge: layers of cells
     * shrink towards it and towards the sides of the teeth. In turn a layer across the lip, the
     * degree, a layer around the tooth and one more across the lip are added; cells also shrink
     * towards the singular edges where flange and ring meet, so that each step shows their error,
     * too.
     */
    static ContactDiscretisation level(const unsigned int level);

    bool operator==(const ContactDiscretisation &other) const
    {
      return degree == other.degree && tooth == other.tooth && lip == other.lip &&
             rotor == other.rotor && lip_turn == other.lip_turn;
    }
  };

  /** The finite element model of a tooth, cut off the base at its foot. */
  struct ToothBody
  {
    /** @param is_clamped whether its foot is clamped */
    ToothBody(const Parameters &parameters, const ContactDiscretisation &discretisation,
              const bool is_clamped = false);

    /** Its top is the interface, the motion of its foot is prescribed. @param angular_frequency
     * rad/s, of a tooth with inertia; @param with_interior see Condensation */
    Condensation condensed(const double angular_frequency = 0.,
                           const bool with_interior       = false) const;

    /** The real and the imaginary part of a wave at the foot, as Condensation expects them. */
    std::vector<double> foot_motion(const WaveMotion &wave) const;

    /** The motion of the top's nodes (m) if a wave moves the foot, without forces on the top. */
    std::vector<std::array<std::complex<double>, 3>>
    top_motion(const WaveMotion &wave, const Condensation &condensed) const;

    const SectorMesh mesh;
    const CyclicSector sector;
    const ContactSurface top;
    const SectorSurface whole_top;
    const std::vector<SectorNodes::Dof> foot;
  };

  /** The finite element model of one sector of the rotor. */
  struct RotorBody
  {
    RotorBody(const Parameters &parameters, const ContactDiscretisation &discretisation);

    /** Its lip is the interface; the preload on the faces ids::ring_top and the torque
     * on the faces ids::ring_bore, along which the rotor is almost free to move, are
     * supports 0 and 1. */
    Condensation condensed(const bool with_interior = false) const;

    /** The supports that are needed for k waves: the rotor rises and turns freely, and tilts almost
     * freely; without bars it also shifts. */
    std::vector<unsigned int> held(const unsigned int k) const;

    /** The inertia of the meshed half sector for the motion of one of these supports: twice its
     * kinetic energy (both fields) at a unit speed of the support.
     * @param condensation with interior recovery */
    double inertia(const Condensation &condensation, const unsigned int k,
                   const unsigned int support) const;

    const SectorMesh mesh;
    const CyclicSector sector;
    const ContactSurface lip;
    const SectorSurface whole_lip;
    const bool has_bars;
  };

  /** The displacements of a mode on a surface, the real field, then the imaginary one.
   * @param displacements displacement_forms() of the surface */
  std::vector<double> on_surface(const CyclicSector &sector,
                                 const std::vector<LinearForm> &displacements, const Mode &mode);
} // namespace ringmotor
