// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_solver.h>
#include <ringmotor/motor/contact_bodies.h>
#include <ringmotor/motor/ring_modes.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/complex.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** The travelling wave that drives the motor, as the stator's modes tell it. */
  struct StatorWave
  {
    unsigned int n_waves     = 0;
    double angular_frequency = 0.; ///< rad/s
    double relative_error    = 0.; ///< of the speed of its surface
    double strain_energy     = 0.; ///< J, of the whole ring; constant in time
    WaveMotion foot;               ///< between base and tooth
    WaveMotion top;                ///< of the tooth's top
    std::string fingerprint;       ///< of these motions: tells them from all others
  };

  /** What the contact needs to know of a motor: everything elastic in one matrix. */
  struct CondensedMotor
  {
    /** A contact point of tooth 0. */
    struct Node
    {
      double radius; ///< m
      double angle;  ///< rad
      double area;   ///< m^2
      std::array<std::complex<double>, 3>
          free_motion; ///< m, of the tooth without contact forces, see PointVector

      template <class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &radius &angle &area &free_motion;
      }
    };

    unsigned int n_teeth = 0, n_waves = 0;
    double angular_frequency = 0.; ///< rad/s
    double wave_energy       = 0.; ///< J, strain energy of the stator's wave in the whole ring
    /** A motion of the rotor with one wave around the ring that hardly anything holds: a tilt or,
     * without bars, a shift. */
    struct NearRigidMode
    {
      std::vector<std::array<std::complex<double>, 3>> motion; ///< of the rotor at each node of
                                                               ///< tooth 0; times exp(-i theta_j)
                                                               ///< for tooth j
      double stiffness;    ///< of the whole ring against the real or the imaginary part
      double inertia = 0.; ///< likewise; 0: it follows its loads at once

      template <class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &motion &stiffness &inertia;
      }
    };

    std::vector<Node> nodes;
    std::vector<NearRigidMode> near_rigid_modes;
    double rotor_mass = 0.;       ///< kg, against its rise; 0: it follows its loads at once
    RingModes modes;              ///< of rotor and teeth, as far as they have inertia or damping
    RingModes coarse_modes;       ///< with those of the rotor of the level below: tell the error
    unsigned int modes_level = 0; ///< of the rotor, see RotorVibration
    RingDynamics dynamics;        ///< of these modes
    RingCompliance compliance;    ///< of rotor and teeth, relative motion of rotor against stator
    RingCompliance folded; ///< the same of the part that repeats itself; empty if nothing does
    ComplementarityConstants constants{};
    dealii::FullMatrix<double> tooth_compliance;  ///< of a tooth alone, m/N
    std::vector<std::vector<unsigned int>> faces; ///< nodes of each face, as ContactSurface::faces
    unsigned int degree;                          ///< of displacements on a face
    unsigned int n_dofs;                          ///< of both bodies

    /** How often the wave repeats itself around the ring on equal teeth: gcd(n, N). */
    unsigned int n_repeats() const;
    /** Whether modes of the rotor take part. */
    bool has_rotor_modes() const;
    /** The compliance of the part that repeats itself. */
    const RingCompliance &repeating() const { return n_repeats() > 1 ? folded : compliance; }

    double period() const;
    double pitch() const;
    /** Of a rotor that moves with the crests of the free wave where these are fastest, rad/s. */
    double crest_speed() const;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &n_teeth &n_waves &angular_frequency &wave_energy &nodes &near_rigid_modes &compliance
          &folded;
      archive &constants.normal &constants.tangential &tooth_compliance &faces &degree &n_dofs;
      archive &rotor_mass &modes &coarse_modes &modes_level &dynamics;
    }
  };

  /** Relative change of the tangential motion of the tooth tops, the largest one, by the inertia of
   * the teeth. */
  double tooth_inertia_indicator(const Parameters &parameters, const StatorWave &wave);

  class RotorVibration;

  /**
   * Condenses teeth and rotor of a motor to their contact points. Looks at
   * relevant_for_condensation() of the parameters only.
   * @param modes_level of the rotor, from 1, see RotorVibration; none: the finest one
   * @param vibration of the rotor, which is the same for all discretisations; without it, it is
   * computed
   * @throws UserError if the lip misses the teeth
   */
  CondensedMotor condense_motor(const Parameters &parameters, const StatorWave &wave,
                                const ContactDiscretisation &discretisation,
                                const std::optional<unsigned int> &modes_level = {},
                                const RotorVibration *vibration                = nullptr);
} // namespace ringmotor
