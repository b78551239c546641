// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/steady.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ringmotor
{
  namespace
  {
    constexpr unsigned int most_rounds = 60; ///< of an update of the memory

    /** What points remember in the steady state: what happened one step earlier. */
    std::vector<FrictionMemory> travelled(const RingContact &contact,
                                          const ContactSolution &solution)
    {
      const unsigned int n_points = contact.n_points();
      std::vector<FrictionMemory> memory(n_points);
      for (unsigned int point = 0; point < n_points; ++point)
      {
        unsigned int before  = contact.earlier(point);
        memory[point].stuck  = solution.status[before] == PointStatus::stick;
        unsigned int n_steps = 0;
        while (solution.status[before] == PointStatus::slip && n_steps++ < n_points)
        {
          memory[point].slipped += tangential_norm(solution.motion[before]);
          before = contact.earlier(before);
        }
      }
      return memory;
    }

    /** What a user can do where the law itself stands in the way. */
    std::string remedy(const FrictionLaw law)
    {
      return law == FrictionLaw::velocity
                 ? "; friction that falls with the velocity falls the faster with the slip of a "
                   "step the shorter the step is, and points may then stick or slip at the same "
                   "load: try a smaller Time/Snapshots or a larger Friction/Decay velocity"
                 : std::string();
    }
  } // namespace

  std::vector<FrictionMemory> next_memory(const ContactSolution &solution,
                                          const std::vector<FrictionMemory> &earlier)
  {
    std::vector<FrictionMemory> memory(earlier.size());
    for (unsigned int point = 0; point < memory.size(); ++point)
    {
      memory[point].stuck = solution.status[point] == PointStatus::stick;
      if (solution.status[point] == PointStatus::slip)
        memory[point].slipped = earlier[point].slipped + tangential_norm(solution.motion[point]);
    }
    return memory;
  }

  SteadyDriver::SteadyDriver(const CondensedMotor &motor, const Friction &friction,
                             const unsigned int n_moments)
      : motor(motor), friction(friction), n_moments(n_moments)
  {
  }

  OperatingState SteadyDriver::find(const RotorLoad &load, const ContactState &begin,
                                    const double speed) const
  try
  {
    const auto contact = std::make_shared<const RingContact>(motor, load, n_moments);
    const bool jumps   = friction.law == FrictionLaw::static_dynamic;
    // The law with a jump starts with the static limit everywhere; points only lose it.
    std::vector<FrictionMemory> memory(contact->n_points(), {jumps, 0.});
    const PointFriction law = [&](const unsigned int point, const double slip)
    { return friction_coefficient(friction, memory[point], slip, contact->time_step()); };
    unsigned int n_iterations = 0;
    ContactState from         = begin;
    from.rigid.resize(contact->n_rigid());
    if (load.torque)
      from.rigid.back() = speed * contact->time_step();
    for (unsigned int round = 0; round < most_rounds; ++round)
    {
      ContactSolution solution                = solve_contact(*contact, law, motor.constants, from);
      n_iterations                            = solution.n_iterations += n_iterations;
      from                                    = solution.state;
      const std::vector<FrictionMemory> found = travelled(*contact, solution);
      bool settled                            = true;
      for (unsigned int point = 0; point < memory.size(); ++point)
        if (jumps)
        {
          const bool falls = memory[point].stuck && solution.status[point] != PointStatus::open &&
                             (!found[point].stuck || solution.status[point] == PointStatus::slip);
          settled             = settled && !falls;
          memory[point].stuck = memory[point].stuck && !falls;
        }
        else if (friction.law == FrictionLaw::slip_weakening)
        {
          settled = settled && std::abs(found[point].slipped - memory[point].slipped) <=
                                   1e-9 * *friction.weakening_length;
          memory[point] = found[point];
        }
      if (settled)
        return {contact, std::move(solution), std::move(memory)};
    }
    throw ComputationError("the memory of the friction law did not settle in " +
                           std::to_string(most_rounds) + " rounds");
  }
  catch (const ComputationError &error)
  {
    throw ComputationError(error.what() + remedy(friction.law));
  }

  void SteadyDriver::start(const double preload)
  {
    // Somewhat below the speed of the wave's crests, where the rotor turns without load.
    double crest = 0.;
    for (const CondensedMotor::Node &node : motor.nodes)
      crest =
          std::max(crest, motor.angular_frequency * std::abs(node.free_motion[1]) / node.radius);
    const RotorLoad load{preload, {}, 0.97 * crest};
    const RingContact contact(motor, load, n_moments);
    last = find(load, contact.pressed_down(), load.speed);
  }

  OperatingState SteadyDriver::at(const RotorLoad &load)
  {
    if (!last)
      start(load.preload);
    last = find(load, last->solution.state, last->contact->speed(last->solution.state));
    return *last;
  }

  namespace
  {
    /** The state of one time sample, seen at several: between two steps of the coarse state forces
     * grow linearly. */
    ContactState with_more_samples(const RingContact &coarse, const ContactState &state,
                                   const RingContact &fine)
    {
      ContactState result{std::vector<PointVector>(fine.n_points()),
                          std::vector<double>(fine.n_rigid())};
      const unsigned int n_samples = fine.n_times(), n_points = coarse.n_points(),
                         n_rigid = coarse.n_rigid_motions();
      for (unsigned int m = 0; m < n_samples; ++m)
      {
        // The earlier point was a step ago what this one is now, and is now what this one will be.
        const double later = m / static_cast<double>(n_samples);
        for (unsigned int i = 0; i < n_points; ++i)
        {
          const unsigned int earlier = coarse.earlier(i);
          result.force[m * n_points + i] += (1. - later) * state.force[i];
          result.force[m * n_points + earlier] += later * state.force[i];
        }
        for (unsigned int r = 0; r < n_rigid; ++r)
          result.rigid[m * n_rigid + r] = state.rigid[r];
      }
      if (state.rigid.size() > n_rigid)
        result.rigid.back() = state.rigid.back() / n_samples;
      return result;
    }
  } // namespace

  void SteadyDriver::go_on_from(const RotorLoad &load, const ContactState &state)
  {
    const auto contact   = std::make_shared<const RingContact>(motor, load, n_moments),
               coarse    = std::make_shared<const RingContact>(motor, load, 1);
    last                 = OperatingState{contact, {}, {}};
    last->solution.state = n_moments > 1 && state.force.size() == coarse->n_points()
                               ? with_more_samples(*coarse, state, *contact)
                               : state;
  }
} // namespace ringmotor
