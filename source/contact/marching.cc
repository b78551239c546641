// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/marching.h>

namespace ringmotor
{
  MarchingDriver::MarchingDriver(const CondensedMotor &motor, const Friction &friction,
                                 const Warp &warp, const double preload)
      : motor(motor), friction(friction), warp(warp)
  {
    const unsigned int n_points = motor.n_teeth * motor.nodes.size();
    const TimeStep at_rest{now, motor.period(), std::vector<PointVector>(n_points)};
    const RotorLoad load{preload, {}};
    // On teeth without warp it is plain how many of them will touch.
    const RingContact even(motor, load, at_rest, Warp()), contact(motor, load, at_rest, warp);
    state     = solve_without_friction(even, motor.constants, even.pressed_down()).state;
    state     = solve_without_friction(contact, motor.constants, state).state;
    positions = contact.positions(state);
    memory.resize(n_points);
  }

  OperatingState MarchingDriver::step(const RotorLoad &load, const double length)
  {
    const TimeStep time_step{now + length, length, positions};
    const auto contact = std::make_shared<const RingContact>(motor, load, time_step, warp);
    std::vector<FrictionMemory> limits = memory;
    const PointFriction law            = [&](const unsigned int point, const double slip)
    { return friction_coefficient(friction, limits[point], slip, length); };
    ContactState begin = state;
    if (load.torque)
      begin.rigid.push_back(last_speed * length);
    ContactSolution solution = solve_contact(*contact, law, motor.constants, begin);
    while (lose_static_limits(solution, limits))
    {
      const unsigned int n_iterations = solution.n_iterations;
      solution = solve_contact(*contact, law, motor.constants, solution.state);
      solution.n_iterations += n_iterations;
    }
    now += length;
    positions  = contact->positions(solution.state);
    memory     = next_memory(solution, memory);
    last_speed = contact->speed(solution.state);
    state      = solution.state;
    state.rigid.resize(contact->n_rigid() - (load.torque ? 1 : 0));
    return {contact, std::move(solution), std::move(limits)};
  }

  bool MarchingDriver::lose_static_limits(const ContactSolution &solution,
                                          std::vector<FrictionMemory> &limits) const
  {
    if (friction.law != FrictionLaw::static_dynamic)
      return false;
    bool lost = false;
    for (unsigned int point = 0; point < limits.size(); ++point)
      if (limits[point].stuck && solution.status[point] == PointStatus::slip)
      {
        limits[point].stuck = false;
        lost                = true;
      }
    return lost;
  }
} // namespace ringmotor
