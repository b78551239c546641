// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/mortar.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/pictures/ring_body.h>
#include <ringmotor/points/curve_point.h>

#include <vector>

namespace ringmotor
{
  /** A time sample of an operating point. */
  struct PointSample
  {
    const ContactFields &fields;
    unsigned int sample; ///< in fields.times
    double amplitude;    ///< m, of the wave
  };

  /**
   * Rotor and teeth of a motor over the whole ring, and their motion, interior included, recovered
   * from the fields at their contact nodes. The bodies are condensed again for it. If an effect is
   * off, its forces are left out: those on the teeth, or friction on the rotor.
   */
  class MotorBodies
  {
  public:
    /** @param discretisation the same as that of the condensed motor
     *  @param n_subdivisions of a cell per direction, see RingBody
     *  @param ranks share the nodal diameters of the rotor
     *
     *  The references must outlive this object. */
    MotorBodies(const Parameters &parameters, const StatorWave &wave,
                const ContactDiscretisation &discretisation, const unsigned int n_subdivisions = 1,
                MPI_Comm ranks = MPI_COMM_SELF);

    /** In its position at rest, with the lip's lower face in the plane of the tooth tops. */
    const RingBody &rotor() const { return rotor_ring; }
    const RingBody &teeth() const { return tooth_ring; }

    /** The displacement of the rotor without its rotation, at each time sample. Collective.
     * @param motor in which the points were found
     * @param vibration of the rotor, if the motor has its modes: those whose interior is not kept
     * there are computed again
     * @throws ComputationError if that finds others */
    std::vector<RingBody::Displacement>
    rotor_motions(const CondensedMotor &motor, const RotorVibration &vibration,
                  const std::vector<PointSample> &samples) const;
    /** The displacement of the teeth, including a static warp. */
    std::vector<RingBody::Displacement>
    teeth_motions(const std::vector<PointSample> &samples) const;

  private:
    using Amplitudes = std::vector<std::array<std::complex<double>, 3>>;

    /** Adds this rank's share of the displacement by forces and rigid motions, as if the rotor had
     * no inertia. */
    void add_static_motion(const std::vector<PointSample> &samples,
                           std::vector<RingBody::Displacement> &displacements) const;
    /** Adds this rank's share of what inertia and damping contribute. */
    void add_vibration(const CondensedMotor &motor, const RotorVibration &vibration,
                       const std::vector<PointSample> &samples,
                       std::vector<RingBody::Displacement> &displacements) const;
    /** The rank that keeps the modes of each nodal diameter, or none. Collective. */
    std::vector<unsigned int> keepers(const RotorModeSolver &solver) const;
    /** The modes of the motor's rotor with @p k nodal diameters found again, of the whole sector.
     * @param of_modes coupling of the teeth to the solver's mesh
     * @throws ComputationError if they are others */
    std::vector<Mode> modes_of(const CondensedMotor &motor, const unsigned int k,
                               RotorModeSolver &solver, const MortarCoupling &of_modes) const;
    /** Amplitudes of the forces on a sector's lip, by node, for each nodal diameter. */
    std::vector<Amplitudes> lip_forces(const PointSample &at) const;

    const Parameters &parameters;
    const MotorModel model;
    const StatorWave &wave;
    const double lip_turn;
    const ToothBody tooth_body;
    const RotorBody rotor_body;
    const MortarCoupling mortar;
    const RingBody rotor_ring, tooth_ring;
    const MPI_Comm ranks;
  };
} // namespace ringmotor
