// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/rigid_inertia.h>

namespace ringmotor
{
  MarchedRigidMotions::MarchedRigidMotions(const MotorInUse &motor,
                                           const std::vector<double> &displacements)
      : scheme(motor.dynamics.scheme)
  {
    for (unsigned int r = 0; r < displacements.size(); ++r)
      motions.push_back(
          {r == 0 ? motor.bodies.rotor_mass : motor.bodies.near_rigid_modes[(r - 1) / 2].inertia,
           {displacements[r], 0., 0.}});
  }

  std::vector<InertiaInStep> MarchedRigidMotions::in_step(const double dt) const
  {
    std::vector<InertiaInStep> inertia;
    for (const Motion &motion : motions)
    {
      // M a is M / response times the deviation from the free motion.
      const double stiffness = motion.inertia / scheme.response_in_step(dt, 0., damping);
      const double free = without_force(scheme, motion.state, dt, 0., damping).displacement.real();
      inertia.push_back({stiffness, stiffness * free});
    }
    return inertia;
  }

  double MarchedRigidMotions::step(const std::vector<double> &displacements, const double dt)
  {
    double power = 0.;
    for (unsigned int r = 0; r < motions.size(); ++r)
    {
      Motion &motion         = motions[r];
      const ModalState begin = motion.state;
      motion.state           = without_force(scheme, begin, dt, 0., damping);
      const double force     = (displacements[r] - motion.state.displacement.real()) /
                           scheme.response_in_step(dt, 0., damping); // per mass
      add_force(scheme, force, dt, 0., damping, motion.state);
      const double net_force = motion.inertia * force;
      power += 0.5 * (net_force + motion.net_force) *
               (motion.state.displacement - begin.displacement).real() / dt;
      motion.net_force = net_force;
    }
    return power;
  }
} // namespace ringmotor
