// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/rigid_inertia.h>

namespace ringmotor
{
  std::vector<RigidMotionState> rigid_motions_at_rest(const std::vector<double> &displacements)
  {
    std::vector<RigidMotionState> states;
    for (const double displacement : displacements)
      states.push_back({{displacement, 0., 0.}});
    return states;
  }

  MarchedRigidMotions::MarchedRigidMotions(const MotorInUse &motor,
                                           const std::vector<RigidMotionState> &states)
      : scheme(motor.dynamics.scheme)
  {
    for (unsigned int r = 0; r < states.size(); ++r)
      motions.push_back(
          {r == 0 ? motor.bodies.rotor_mass : motor.bodies.near_rigid_modes[(r - 1) / 2].inertia,
           states[r]});
  }

  std::vector<RigidMotionState> MarchedRigidMotions::current() const
  {
    std::vector<RigidMotionState> states;
    for (const Motion &motion : motions)
      states.push_back(motion.now);
    return states;
  }

  std::vector<InertiaInStep> MarchedRigidMotions::in_step(const double dt) const
  {
    std::vector<InertiaInStep> inertia;
    for (const Motion &motion : motions)
    {
      // M a is M / response times the deviation from the free motion.
      const double stiffness = motion.inertia / scheme.response_in_step(dt, 0., damping);
      const double free =
          without_force(scheme, motion.now.motion, dt, 0., damping).displacement.real();
      inertia.push_back({stiffness, stiffness * free});
    }
    return inertia;
  }

  double MarchedRigidMotions::step(const std::vector<double> &displacements, const double dt)
  {
    double power = 0.;
    for (unsigned int r = 0; r < motions.size(); ++r)
    {
      auto &[motion, net_force] = motions[r].now;
      const ModalState begin    = motion;
      motion                    = without_force(scheme, begin, dt, 0., damping);
      const double force        = (displacements[r] - motion.displacement.real()) /
                           scheme.response_in_step(dt, 0., damping); // per mass
      add_force(scheme, force, dt, 0., damping, motion);
      const double before = net_force;
      net_force           = motions[r].inertia * force;
      power += 0.5 * (net_force + before) * (motion.displacement - begin.displacement).real() / dt;
    }
    return power;
  }
} // namespace ringmotor
