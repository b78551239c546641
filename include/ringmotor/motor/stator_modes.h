// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/condensed_bodies.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/rotor_modes.h>

#include <map>
#include <memory>
#include <vector>

namespace ringmotor
{
  class StatorShape;

  /** The finite element model of one sector of the whole stator, and that of its tooth alone,
   * clamped at its foot, on the same cells. */
  struct StatorBody
  {
    /** @param level of the mesh and the degree, see RotorVibration */
    StatorBody(const Parameters &parameters, const unsigned int level);

    /** The least nodal diameter whose motions are known: with fewer a stator that nothing clamps
     * moves freely as a whole. */
    unsigned int least_diameter() const { return is_clamped ? 0 : 2; }

    const SectorMesh mesh, tooth_mesh;
    const CyclicSector sector, tooth;
    const ContactSurface top, top_of_tooth;
    const SectorSurface whole_top;
    const bool is_clamped; ///< somewhere on the base

  private:
    StatorBody(const StatorShape &stator, const Parameters &parameters, const unsigned int level);
  };

  /**
   * What the base below the teeth adds to their motion under contact forces. Its response depends
   * on the frequency from the first harmonic of the wave on: below that of the wave are modes with
   * fewer waves, which move by their inertia, near it are others with as many. So it is a sum of
   * modes with their inertia, and no static compliance is added for it: the ResponseModes of the
   * whole stator, for smooth forces on the tooth tops at rest and at the frequencies of the
   * harmonics, less what those of a tooth that is clamped at its foot give at rest, which the
   * static compliance of the teeth contains. Vectors far above these frequencies respond as at
   * rest. The mode that drives the motor is left out: it is the wave, which is given, or follows
   * from the voltage.
   *
   * Nodal diameters that no considered harmonic has, and those below
   * StatorBody::least_diameter(), find the base rigid.
   */
  class StatorModes
  {
  public:
    /**
     * @param wave whose mode is left out
     * @param level of the mesh @param n_harmonics of the wave that are considered
     * @param communicator of the ranks that share the nodal diameters
     * @throws ComputationError if no mode looks like the wave
     */
    StatorModes(const Parameters &parameters, const StatorWave &wave, const unsigned int level,
                const unsigned int n_harmonics, MPI_Comm communicator = MPI_COMM_SELF);

    /** At the contact points of @p mortar on @p tooth_top, by nodal diameter. */
    RingModes at(const ContactSurface &tooth_top, const MortarCoupling &mortar) const;

    /** The same at the nodes of StatorBody::whole_top. */
    const RingModes &at_nodes() const { return modes; }
    /** The mode that is left out, at these nodes. */
    const RingMode &driven() const { return of_wave; }

  private:
    SectorSurface top;
    RingModes modes; ///< at its nodes
    RingMode of_wave;
  };

  /** The modes of the stator at the levels of RotorVibration. Computed lazily. */
  class StatorVibration
  {
  public:
    StatorVibration(const Parameters &parameters, const StatorWave &wave,
                    MPI_Comm communicator = MPI_COMM_SELF);

    /** @param setting of which the mesh and the low harmonics count. Collective where it computes
     * something */
    const StatorModes &modes(const VibrationSetting &setting) const;

  private:
    Parameters parameters;
    StatorWave wave;
    MPI_Comm communicator;
    /** By mesh and number of harmonics. */
    mutable std::map<std::pair<unsigned int, unsigned int>, std::shared_ptr<const StatorModes>>
        known;
  };

  /** What all condensations of a motor share: the vibrations of both bodies, and these bodies
   * themselves. */
  struct MotorVibration
  {
    MotorVibration(const Parameters &parameters, const StatorWave &wave,
                   MPI_Comm communicator = MPI_COMM_SELF);

    /** Computes what condense_motor() reads for a @p model: before ranks condense different motors.
     * Collective. */
    void prepare(const MotorModel &model, const unsigned int modes_level,
                 const ModeSets sets = ModeSets::with_compared) const;

    RotorVibration rotor;
    StatorVibration stator;
    BodiesByMesh bodies;
  };
} // namespace ringmotor
