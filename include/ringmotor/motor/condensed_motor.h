// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_solver.h>
#include <ringmotor/motor/contact_bodies.h>
#include <ringmotor/motor/rest_gap.h>
#include <ringmotor/motor/ring_modes.h>
#include <ringmotor/motor/voltage_drive.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/complex.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <complex>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** The travelling wave that drives the motor, from the modes of the stator. */
  struct StatorWave
  {
    unsigned int n_waves     = 0;
    double angular_frequency = 0.;     ///< rad/s
    double amplitude         = 0.;     ///< m, normal, at the outer edge of the tooth tops
    double relative_error    = 0.;     ///< of its surface speed
    double strain_energy     = 0.;     ///< J, of the whole ring; constant in time
    WaveMotion foot;                   ///< at the interface between base and tooth
    WaveMotion top;                    ///< of the tooth's top
    std::string fingerprint;           ///< identifies these motions
    std::optional<VoltageDrive> drive; ///< if the voltage is given; the amplitude above is then
                                       ///< that of these motions and of no operating point

    /** Identifies the motions and their drive. */
    std::string identity() const { return fingerprint + (drive ? ", " + drive->text() : ""); }
  };

  /** The stator's wave as contact nodes feel it. */
  struct WaveAtNodes
  {
    double amplitude         = 0.; ///< m, see StatorWave
    double angular_frequency = 0.; ///< rad/s
    double energy            = 0.; ///< J, strain energy in the whole ring
    /** m, of the nodes of tooth 0 without contact forces, see PointVector. */
    std::vector<std::array<std::complex<double>, 3>> free_motion;

    /** A wave of the same shape at an amplitude (m) and a frequency (rad/s). */
    WaveAtNodes at(const double other_amplitude, const double other_frequency) const;
    double period() const;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &amplitude &angular_frequency &energy &free_motion;
    }
  };

  /** Which vibrations of its bodies a motor has. */
  enum class ModeSets
  {
    own,          ///< CondensedMotor::modes
    with_compared ///< also those that tell their error
  };

  /** The data of a motor that contact needs: all elasticity condensed into one compliance. */
  struct CondensedMotor
  {
    /** A contact point of tooth 0. */
    struct Node
    {
      double radius; ///< m
      double angle;  ///< rad
      double area;   ///< m^2

      template <class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &radius &angle &area;
      }
    };

    unsigned int n_teeth = 0, n_waves = 0;
    WaveAtNodes wave; ///< as it was requested
    /** A motion of the rotor with one wave around the ring that meets almost no stiffness: a tilt
     * or, without bars, a shift. */
    struct NearRigidMode
    {
      std::vector<std::array<std::complex<double>, 3>> motion; ///< of the rotor at each node of
                                                               ///< tooth 0; times exp(-i theta_j)
                                                               ///< for tooth j
      double stiffness;    ///< of the whole ring, for the real or the imaginary part
      double inertia = 0.; ///< likewise; 0: quasi-static

      template <class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &motion &stiffness &inertia;
      }
    };

    std::vector<Node> nodes;
    std::vector<NearRigidMode> near_rigid_modes;
    double rotor_mass = 0.;             ///< kg, for its rise; 0: quasi-static
    RestGap gap;                        ///< of the faces in contact
    RingModes modes;                    ///< of its bodies if they have inertia or damping
    RingModes coarse_modes;             ///< on the next coarser mesh: error estimate
    RingModes modes_of_other_harmonics; ///< on that mesh, see RotorVibration: error estimate
    unsigned int modes_level = 0;       ///< see RotorVibration
    RingDynamics dynamics;              ///< of these modes
    RingCompliance compliance; ///< of rotor and teeth, relative motion of rotor against stator
    RingCompliance folded;     ///< the same for the repeating part; empty if nothing repeats
    ComplementarityConstants constants{};
    dealii::FullMatrix<double> tooth_compliance;  ///< of a single tooth, m/N
    std::vector<std::vector<unsigned int>> faces; ///< nodes of each face, as ContactSurface::faces
    unsigned int degree; ///< polynomial degree of the displacements on a face
    unsigned int n_dofs; ///< of both bodies together

    /** Number of repetitions of the wave and the teeth around the ring: gcd(n, N). */
    unsigned int n_repeats() const;
    /** Whether the model contains modes. */
    bool has_modes() const { return !modes.empty(); }
    /** Whether it contains modes of a part. */
    bool has_modes_of(const ModePart part) const;
    /** The compliance of the repeating part. */
    const RingCompliance &repeating() const { return n_repeats() > 1 ? folded : compliance; }

    double period() const { return wave.period(); }
    double pitch() const;
    /** Speed (rad/s) of a rotor that follows the crests of a free wave where they are fastest. */
    double crest_speed(const WaveAtNodes &of_wave) const;
    double crest_speed() const { return crest_speed(wave); }

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &n_teeth &n_waves &wave &nodes &near_rigid_modes &compliance &folded;
      archive &constants.normal &constants.tangential &tooth_compliance &faces &degree &n_dofs;
      archive &rotor_mass &gap &modes &coarse_modes &modes_of_other_harmonics &modes_level
          &dynamics;
    }
  };

  /** A condensed motor with what a search may vary of it, so that nothing large is copied. */
  struct MotorInUse
  {
    /** As it was condensed. @p bodies must outlive this object. */
    MotorInUse(const CondensedMotor &bodies)
        : bodies(bodies), wave(bodies.wave), modes(&bodies.modes), dynamics(bodies.dynamics)
    {
    }

    /** Without the vibrations of rotor and teeth, which respond as at rest then. */
    void leave_modes_of_stator_alone();

    const CondensedMotor &bodies;
    WaveAtNodes wave;
    const RingModes *modes; ///< of the bodies, or #own_modes
    RingDynamics dynamics;  ///< of these modes

  private:
    std::shared_ptr<const RingModes> own_modes;
  };

  /** A motor, and the time (s, wall clock) that it took to condense or to read it. */
  struct TimedMotor
  {
    CondensedMotor motor;
    double seconds = 0.;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &motor &seconds;
    }
  };

  struct MotorVibration;

  /**
   * Condenses the teeth and the rotor of a motor to their contact points. Depends only on
   * relevant_for_condensation() of the parameters.
   * @param modes_level of the rotor, from 1, see RotorVibration; none: the usual one
   * @param vibration of its bodies, which is the same for all discretisations; computed if not
   * given
   * @param sets which of the motor's modes are wanted
   * @throws UserError if the lip misses the teeth
   */
  CondensedMotor condense_motor(const Parameters &parameters, const StatorWave &wave,
                                const ContactDiscretisation &discretisation,
                                const std::optional<unsigned int> &modes_level = {},
                                const MotorVibration *vibration                = nullptr,
                                const ModeSets sets = ModeSets::with_compared);
} // namespace ringmotor
