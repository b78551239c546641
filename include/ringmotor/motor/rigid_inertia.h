// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/condensed_motor.h>

#include <vector>

namespace ringmotor
{
  /** The contribution of inertia to the balance of a rigid or near-rigid motion q of the rotor at
   * the end of a step: forces on it = stiffness q - load, in addition to its static stiffness. */
  struct InertiaInStep
  {
    double stiffness =
        0.;           ///< N/m for the rise, the unit of NearRigidMode::stiffness for the others
    double load = 0.; ///< from the motion so far
  };

  /** One of the motions of a rotor as a whole at the end of a step. */
  struct RigidMotionState
  {
    ModalState motion;
    double net_force = 0.; ///< at the end of the step

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &motion &net_force;
    }
  };

  /** At rest at some displacements. */
  std::vector<RigidMotionState> rigid_motions_at_rest(const std::vector<double> &displacements);

  /**
   * The motions of a rotor as a whole, its rise and its near-rigid modes, marched through time with
   * inertia: each like a vibration mode, except that its displacement is an unknown of the contact
   * problem. Motions are numbered as in RingContact.
   */
  class MarchedRigidMotions
  {
  public:
    MarchedRigidMotions(const MotorInUse &motor, const std::vector<RigidMotionState> &states);

    std::vector<RigidMotionState> current() const;

    /** The contributions in a step @p dt (s). */
    std::vector<InertiaInStep> in_step(const double dt) const;
    /** Advances by a step @p dt to given displacements. @return W, mean over the step of the power
     * that goes into kinetic energy and is dissipated by the scheme */
    double step(const std::vector<double> &displacements, const double dt);

    /** 1/s, of all motions; none by default. */
    double damping = 0.;

  private:
    struct Motion
    {
      double inertia;
      RigidMotionState now;
    };

    const InertiaScheme scheme;
    std::vector<Motion> motions;
  };
} // namespace ringmotor
