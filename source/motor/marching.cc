// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/friction_law.h>
#include <ringmotor/motor/marching.h>

#include <algorithm>
#include <numeric>

namespace ringmotor
{
  MarchingDriver::MarchingDriver(const MotorInUse &in_use, const Friction &friction,
                                 const Warp &warp, const double preload)
      : in_use(in_use), motor(in_use.bodies), friction(friction), warp(warp), history(motor, warp)
  {
    const unsigned int n_points = motor.n_teeth * motor.nodes.size();
    const TimeStep at_rest{0., in_use.wave.period(), std::vector<PointVector>(n_points)};
    const RotorLoad load{preload, {}};
    const RingContact contact(in_use, load, at_rest, warp);
    StepEnd start;
    start.state = solve_without_friction(contact, motor.constants, contact.pressed_down()).state;
    positions   = contact.positions(start.state);
    if (!in_use.modes->empty())
    {
      modes.emplace(*in_use.modes, motor.n_teeth, in_use.dynamics);
      modes->rest(start.state.force);
    }
    if (motor.rotor_mass > 0.)
      rigid_motions.emplace(in_use, rigid_motions_at_rest(start.state.rigid));
    history.add(std::move(start));
    memory.resize(n_points);
  }

  MarchingDriver::MarchingDriver(const MotorInUse &in_use, const Friction &friction,
                                 const OperatingState &steady)
      : in_use(in_use), motor(in_use.bodies), friction(friction), warp(), history(motor, warp)
  {
    const RingContact &contact  = *steady.contact;
    const unsigned int n_points = motor.n_teeth * motor.nodes.size();
    const auto first_sample     = [&](const auto &values)
    {
      std::decay_t<decltype(values)> of_ring;
      for (unsigned int i = 0; i < n_points; ++i)
        of_ring.push_back(values[i % (n_points / contact.n_repeats())]);
      return of_ring;
    };
    const ContactState &state = steady.solution.state;
    positions                 = first_sample(contact.positions(state));
    memory                    = first_sample(next_memory(steady.solution, steady.solution.memory));
    StepEnd start;
    start.length = contact.time_step();
    start.speed  = contact.speed(state);
    start.state  = {first_sample(state.force), state.rigid};
    start.motion = first_sample(steady.solution.motion);
    start.state.rigid.resize(contact.n_rigid_motions());
    // A repeating part of a ring has no near-rigid modes, but the whole ring has.
    start.state.rigid.resize(1 + 2 * motor.near_rigid_modes.size());
    if (!in_use.modes->empty())
    {
      modes.emplace(*in_use.modes, motor.n_teeth, in_use.dynamics);
      modes->set(contact.modal_states(state), start.state.force);
    }
    if (motor.rotor_mass > 0.)
      rigid_motions.emplace(in_use, rigid_motions_at_rest(start.state.rigid));
    history.add(std::move(start));
  }

  MarchingDriver::MarchingDriver(const MotorInUse &in_use, const Friction &friction,
                                 const Warp &warp, const MarchedState &from)
      : in_use(in_use), motor(in_use.bodies), friction(friction), warp(warp), history(motor, warp),
        positions(from.positions), memory(from.memory)
  {
    Assert(from.positions.size() == motor.n_teeth * motor.nodes.size() &&
               from.modes.size() == in_use.modes->size() &&
               from.rigid_motions.empty() == (motor.rotor_mass == 0.),
           dealii::ExcMessage("the state of another motor"));
    if (!from.modes.empty())
    {
      modes.emplace(*in_use.modes, motor.n_teeth, in_use.dynamics);
      modes->set(from.modes, from.end.state.force);
    }
    if (!from.rigid_motions.empty())
      rigid_motions.emplace(in_use, from.rigid_motions);
    history.add(from.end);
  }

  MarchedState MarchingDriver::state() const
  {
    return {history.last(), positions, memory,
            modes ? modes->current() : std::vector<std::vector<ModalState>>(),
            rigid_motions ? rigid_motions->current() : std::vector<RigidMotionState>()};
  }

  OperatingState MarchingDriver::step(const RotorLoad &load, const double length,
                                      const Fallback fallback)
  {
    const auto contact = std::make_shared<const RingContact>(in_use, load, next_step(length), warp);
    std::vector<FrictionMemory> limits = memory;
    const PointFriction law            = [&](const unsigned int point, const double slip)
    { return friction_coefficient(friction, limits[point], slip, length); };
    StepEnd begin = history.predict(length);
    if (load.torque)
      begin.state.rigid.push_back(begin.speed * length);
    ContactSolution solution =
        solve_contact(*contact, law, motor.constants, begin.state, begin.motion, solver, fallback);
    while (lose_static_limits(solution, limits))
    {
      const unsigned int n_iterations = solution.n_iterations;
      solution = solve_contact(*contact, law, motor.constants, solution.state, solution.motion,
                               solver, fallback);
      solution.n_iterations += n_iterations;
    }
    positions = contact->positions(solution.state);
    memory    = next_memory(solution, memory);
    const std::vector<double> rigid(solution.state.rigid.begin(),
                                    solution.state.rigid.end() - (load.torque ? 1 : 0));
    solution.memory = std::move(limits);
    solution.speed  = contact->speed(solution.state);
    StepEnd end{solution, time() + length, length};
    end.state.rigid = rigid;
    history.add(std::move(end));
    OperatingState state{contact, std::move(solution)};
    if (modes)
    {
      state.modal_power  = modes->step(state.solution.state.force, length);
      state.modal_motion = modes->motion();
      state.vibration    = modes->vibration();
    }
    if (rigid_motions)
      state.modal_power.taken += rigid_motions->step(rigid, length);
    return state;
  }

  void MarchingDriver::damp(const double loss_factor)
  {
    const double rate = loss_factor * in_use.wave.angular_frequency;
    if (modes)
      modes->damp(rate);
    if (rigid_motions)
      rigid_motions->damping = rate;
    step_length = 0.; // the compliance in a step depends on it
  }

  TimeStep MarchingDriver::next_step(const double length)
  {
    TimeStep step{time() + length, length, positions};
    if (!modes)
      return step;
    if (length != step_length)
    {
      std::vector<unsigned int> teeth(motor.n_teeth);
      std::iota(teeth.begin(), teeth.end(), 0u);
      compliance  = std::make_shared<const BlockCompliance>(motor.compliance, 1,
                                                           modes->compliance(length), teeth);
      step_length = length;
    }
    step.compliance = compliance;
    step.vibration  = modes->free_motion(length);
    if (rigid_motions)
      step.rigid_inertia = rigid_motions->in_step(length);
    return step;
  }

  bool MarchingDriver::lose_static_limits(const ContactSolution &solution,
                                          std::vector<FrictionMemory> &limits) const
  {
    const FrictionLawBase &law = law_of(friction);
    bool lost                  = false;
    for (unsigned int point = 0; point < limits.size(); ++point)
      if (law.lose_static_limit(solution.status[point], limits[point]))
        lost = true;
    return lost;
  }
} // namespace ringmotor
