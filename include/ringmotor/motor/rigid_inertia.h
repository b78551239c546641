// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/condensed_motor.h>

#include <vector>

namespace ringmotor
{
  /** What inertia adds to the balance of a rigid or near-rigid motion q of the rotor at the end of
   * a step: forces on it = stiffness q - load, beside what else holds it. */
  struct InertiaInStep
  {
    double stiffness =
        0.;           ///< by q: N/m of the rise, the unit of NearRigidMode::stiffness of others
    double load = 0.; ///< of the motion so far
  };

  /**
   * The motions of a rotor as a whole, its rise and its near-rigid motions, marched through time
   * with inertia: like a mode each, but for their displacement, which is one of the unknowns of
   * contact. Motions are numbered as in RingContact.
   */
  class MarchedRigidMotions
  {
  public:
    /** At rest at some displacements. */
    MarchedRigidMotions(const CondensedMotor &motor, const std::vector<double> &displacements);

    /** For a step @p dt (s). */
    std::vector<InertiaInStep> in_step(const double dt) const;
    /** Goes on by a step @p dt to some displacements. @return W, mean over the step of what goes
     * into kinetic energy and is lost by the scheme */
    double step(const std::vector<double> &displacements, const double dt);

    /** 1/s, of all motions; none by itself. */
    double damping = 0.;

  private:
    struct Motion
    {
      double inertia;
      ModalState state;
      double net_force = 0.; ///< at the end of the last step
    };

    const InertiaScheme scheme;
    std::vector<Motion> motions;
  };
} // namespace ringmotor
