// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <ringmotor/contact/friction_law.h>
#include <ringmotor/contact/solve/given_coefficients.h>
#include <ringmotor/motor/steady.h>
#include <ringmotor/motor/steady_memory.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <utility>

namespace ringmotor
{
  namespace
  {
    /** Dynamics between two others. @param share of the way from one to the other */
    RingDynamics between(const RingDynamics &one, const RingDynamics &other, const double share)
    {
      RingDynamics dynamics = other;
      dynamics.scheme       = between(one.scheme, other.scheme, share);
      dynamics.share        = (1. - share) * one.share + share * other.share;
      // Halving damping changes the state more than taking away the last tenth of it.
      constexpr double negligible = 1e-3;
      dynamics.added_loss_factor =
          (one.added_loss_factor + negligible) * std::pow((other.added_loss_factor + negligible) /
                                                              (one.added_loss_factor + negligible),
                                                          share) -
          negligible;
      return dynamics;
    }

    /** With what follows from a solution. */
    OperatingState operating_state(const std::shared_ptr<const RingContact> &contact,
                                   ContactSolution solution)
    {
      solution.speed = contact->speed(solution.state);
      OperatingState state{contact, std::move(solution)};
      state.modal_power  = contact->modal_power(state.solution.state);
      state.modal_motion = contact->modal_motion(state.solution.state);
      state.vibration    = contact->vibration_of_modes(state.solution.state);
      return state;
    }
  } // namespace

  std::string text_of(const RotorLoad &load)
  {
    std::ostringstream text;
    text.precision(4);
    if (load.torque)
      text << "at " << 1e3 * *load.torque << " mN m";
    else
      text << "at " << 30. / M_PI * load.speed << " rpm";
    return text.str();
  }

  std::vector<FrictionMemory> next_memory(const StepState &solution,
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

  SteadyDriver::SteadyDriver(const MotorInUse &motor, const Friction &friction,
                             const SteadyStep &step)
      : motor(motor), friction(friction), step(step),
        modes(motor.modes->empty() ? nullptr : by_shapes(*motor.modes))
  {
    set_wave(motor.wave);
  }

  void SteadyDriver::set_wave(const WaveAtNodes &wave)
  {
    const bool has_other_frequency = wave.angular_frequency != motor.wave.angular_frequency;
    motor.wave                     = wave;
    if (modes && (!dynamics || has_other_frequency))
      dynamics = with_inertia(motor.dynamics);
  }

  std::shared_ptr<const SteadyDynamics>
  SteadyDriver::with_inertia(const RingDynamics &of_modes) const
  {
    return std::make_shared<const SteadyDynamics>(motor, modes, step, of_modes);
  }

  OperatingState SteadyDriver::find(const RotorLoad &load, StepState from) const
  {
    return find(load, std::move(from), dynamics,
                dynamics ? last_resort : Fallback::proximal_points);
  }

  OperatingState SteadyDriver::find(const RotorLoad &load, StepState from,
                                    std::shared_ptr<const SteadyDynamics> of_modes,
                                    const Fallback fallback) const
  try
  {
    const auto contact =
        std::make_shared<const RingContact>(motor, load, step, std::move(of_modes));
    RowSolver solver;
    unsigned int n_iterations = 0;
    from.state.rigid.resize(contact->n_rigid());
    if (load.torque)
      from.state.rigid.back() = from.speed * contact->time_step();
    if (law_of(friction).starts_from_given_coefficients())
      from = by_coefficients(*contact, std::move(from), solver, n_iterations);
    SteadyMemory memory(*contact, friction, std::move(from.memory));
    const PointFriction law = [&](const unsigned int point, const double slip)
    { return friction_coefficient(friction, memory[point], slip, contact->time_step()); };
    const auto solved = [&]
    {
      ContactSolution solution = solve_contact(*contact, law, motor.bodies.constants, from.state,
                                               from.motion, solver, fallback);
      n_iterations             = solution.n_iterations += n_iterations;
      from.state               = solution.state;
      from.motion.clear();
      solution.memory = memory.assumed();
      return solution;
    };
    while (memory.n_solutions_so_far() < SteadyMemory::most_solutions)
    {
      ContactSolution solution = solved();
      if (memory.settled(solution))
        return operating_state(contact, std::move(solution));
      const unsigned int n_states = memory.n_alternating();
      if (n_states <= 1)
        continue;
      OperatingState state = operating_state(contact, std::move(solution));
      for (unsigned int other = 1; other < n_states; ++other)
      {
        state.others.push_back(operating_state(contact, solved()));
        memory.settled(state.others.back().solution);
      }
      return state;
    }
    throw ComputationError("the memory of the friction law did not settle in " +
                           std::to_string(SteadyMemory::most_solutions) + " iterations");
  }
  catch (const ComputationError &error)
  {
    throw ComputationError("no steady state found " + text_of(load) + ": " + error.what() +
                           law_of(friction).remedy());
  }

  StepState SteadyDriver::start_at(const OperatingState &state)
  {
    StepState start = state.solution;
    start.memory    = travelled(*state.contact, state.solution);
    return start;
  }

  StepState SteadyDriver::by_coefficients(const RingContact &contact, StepState from,
                                          RowSolver &solver, unsigned int &n_iterations) const
  {
    constexpr unsigned int most_states = 40;
    constexpr double nearly            = 1e-4; // of the coefficients
    const PointFriction law            = [&](const unsigned int point, const double slip)
    { return friction_coefficient(friction, from.memory[point], slip, contact.time_step()); };
    GivenCoefficients coefficients(law, contact.n_points(), from.motion);
    double change = 1.;
    for (unsigned int k = 0; k < most_states && change > nearly; ++k)
    {
      const ContactSolution solution = solve_contact(
          contact,
          [&](const unsigned int i, const double) {
            return FrictionCoefficient{coefficients[i], 0.};
          },
          motor.bodies.constants, from.state, from.motion, solver);
      n_iterations += solution.n_iterations;
      from   = {solution.state, solution.motion, travelled(contact, solution), from.speed, {}};
      change = coefficients.update(from.state, from.motion);
    }
    return from;
  }

  StepState SteadyDriver::from_rest(const RotorLoad &load) const
  {
    if (step.n_samples > 1)
      try
      {
        SteadyDriver coarse(motor, friction, SteadyStep());
        coarse.last_resort = last_resort;
        return start_from(RingContact(motor, load, step), load, coarse.at(load).solution);
      }
      catch (const ComputationError &)
      {
        // There may be a state with short steps only.
      }
    // Without load the rotor turns somewhat slower than the wave's crests.
    const RotorLoad with_speed{
        load.preload, {}, load.torque ? 0.97 * motor.bodies.crest_speed(motor.wave) : load.speed};
    const RingContact contact(motor, with_speed, step);
    // The law with a jump starts with the static limit everywhere.
    const StepState pressed{contact.pressed_down(),
                            {},
                            std::vector<FrictionMemory>(contact.n_points(), {true, 0.}),
                            with_speed.speed,
                            {}};
    if (!load.torque && !dynamics)
      return pressed;
    const StepState start = start_at(find(with_speed, pressed, nullptr));
    if (!dynamics)
      return start;
    RingDynamics at_rest = motor.dynamics;
    at_rest.share        = 0.;
    return by_damping(with_speed, start, at_rest);
  }

  StepState SteadyDriver::by_damping(const RotorLoad &load, StepState from,
                                     const RingDynamics &of_start) const
  {
    constexpr double strongly = 0.3;
    RingDynamics dissipative  = motor.dynamics;
    dissipative.scheme        = InertiaScheme::newmark(1.);
    RingDynamics damped       = dissipative;
    damped.added_loss_factor  = strongly;
    from                      = follow(load, std::move(from), of_start, damped);
    from                      = follow(load, std::move(from), damped, dissipative);
    return follow(load, std::move(from), dissipative, motor.dynamics);
  }

  StepState SteadyDriver::follow(const RotorLoad &load, StepState from, const RingDynamics &begin,
                                 const RingDynamics &end) const
  {
    constexpr double shortest = 1. / 8.;
    const auto by             = [&](const RingDynamics &there, const Fallback fallback)
    { return start_at(find(load, from, with_inertia(there), fallback)); };
    double done = 0., length = 1.;
    while (done < 1.)
      try
      {
        const double next = std::min(1., done + length);
        from              = by(between(begin, end, next), Fallback::none);
        done              = next;
        length *= 2.;
      }
      catch (const ComputationError &)
      {
        length *= 0.5;
        if (length < shortest)
          return by(end, last_resort);
      }
    return from;
  }

  OperatingState SteadyDriver::find_through(const RotorLoad &load, StepState start,
                                            const unsigned int n_stages) const
  {
    constexpr double least = 1e-3;
    for (unsigned int stage = n_stages; stage > 0; --stage)
    {
      RingDynamics damped      = motor.dynamics;
      damped.added_loss_factor = (std::pow(3., stage) - 1.) * std::max(least, damped.loss_factor);
      start                    = start_at(find(load, start, with_inertia(damped), Fallback::none));
    }
    return find(load, start, dynamics, Fallback::none);
  }

  OperatingState SteadyDriver::find_or_damp(const RotorLoad &load, const Way first_way) const
  {
    // In what order, and how a log names what helped.
    std::vector<std::pair<std::string, std::function<OperatingState()>>> attempts;
    if (!dynamics)
      attempts.emplace_back("", [&] { return find(load, *next); });
    else
    {
      for (const Way way : {Way::at_once, Way::by_some_damping})
        for (const StepState *const start : {&*next, other ? &*other : nullptr})
          if (start && way >= first_way)
            // If not at once, it is most often found from the second stage.
            attempts.emplace_back(
                way == Way::at_once ? "from the same point with other steps or another mesh"
                                    : "with a little more damping that is reduced in stages",
                [&load, this, way, start]
                { return find_through(load, *start, way == Way::at_once ? 0 : 2); });
      attempts.emplace_back("with strong damping that is reduced in stages",
                            [&] { return find(load, by_damping(load, *next, motor.dynamics)); });
    }
    attempts.emplace_back(dynamics ? "from the state without inertia" : "from rest",
                          [&] { return find(load, from_rest(load)); });
    std::string tried;
    for (std::size_t i = 0;; ++i)
      try
      {
        OperatingState state = attempts[i].second();
        if (!tried.empty())
          state.solution.how = tried + "; " + attempts[i].first + " it did";
        return state;
      }
      catch (const ComputationError &error)
      {
        if (i + 1 == attempts.size())
          throw;
        if (tried.empty())
          tried = error.what();
      }
  }

  OperatingState SteadyDriver::at(const RotorLoad &load, const Way first_way)
  {
    const OperatingState state = next ? find_or_damp(load, first_way) : find(load, from_rest(load));
    next                       = start_at(state);
    other.reset();
    return state;
  }

  StepState SteadyDriver::at_other_samples(const RingContact &coarse, const StepState &known,
                                           const RingContact &fine)
  {
    const unsigned int n_coarse = coarse.n_time_samples(), n_fine = fine.n_time_samples(),
                       n_points = coarse.n_points() / n_coarse, n_rigid = coarse.n_rigid_motions();
    Assert(known.state.force.size() == coarse.n_points() &&
               known.state.rigid.size() >= n_coarse * n_rigid,
           dealii::ExcMessage("a state on another mesh"));
    const std::vector<FrictionMemory> memory = travelled(coarse, known);
    StepState start{
        {std::vector<PointVector>(fine.n_points()), std::vector<double>(fine.n_rigid())},
        std::vector<PointVector>(fine.n_points()),
        {},
        known.speed,
        {}};
    for (unsigned int m = 0; m < n_fine; ++m)
    {
      const unsigned int before = m * n_coarse / n_fine;
      const double later        = m * n_coarse / static_cast<double>(n_fine) - before;
      for (unsigned int i = 0; i < n_points; ++i)
      {
        const unsigned int point = before * n_points + i;
        start.memory.push_back(memory[point]);
        // After the last time sample comes the state of another tooth at the first one.
        const bool is_last     = before + 1 == n_coarse;
        const unsigned int now = m * n_points + i, next_known = is_last ? i : point + n_points,
                           next_fine = m * n_points + (is_last ? coarse.earlier(i) % n_points : i);
        start.state.force[now] += (1. - later) * known.state.force[point];
        start.state.force[next_fine] += later * known.state.force[next_known];
        start.motion[now] += (1. - later) * known.motion[point];
        start.motion[next_fine] += later * known.motion[next_known];
      }
      for (unsigned int r = 0; r < n_rigid; ++r)
        start.state.rigid[m * n_rigid + r] = known.state.rigid[before * n_rigid + r];
    }
    for (PointVector &motion : start.motion) // slips are smaller in shorter steps
      for (unsigned int c = 1; c < 3; ++c)
        motion[c] *= n_coarse / static_cast<double>(n_fine);
    return start;
  }

  StepState SteadyDriver::start_from(const RingContact &contact, const RotorLoad &load,
                                     const StepState &known) const
  {
    if (known.state.force.size() != contact.n_points())
    {
      SteadyStep coarse;
      coarse.n_samples = known.state.force.size() / (contact.n_points() / contact.n_time_samples());
      return at_other_samples(RingContact(motor, load, coarse), known, contact);
    }
    StepState start = known;
    start.memory    = travelled(contact, known);
    return start;
  }

  void SteadyDriver::go_on_from(const RotorLoad &load, const StepState &known)
  {
    next = start_from(RingContact(motor, load, step), load, known);
    other.reset();
  }

  void SteadyDriver::go_on_by_change(const RotorLoad &load, const StepState &from,
                                     const StepState &to)
  {
    Assert(next, dealii::ExcMessage("there is no state that could change"));
    const RingContact contact(motor, load, step);
    const StepState before = start_from(contact, load, from), after = start_from(contact, load, to);
    for (unsigned int i = 0; i < contact.n_points(); ++i)
    {
      next->state.force[i] += after.state.force[i] - before.state.force[i];
      if (!next->motion.empty())
        next->motion[i] += after.motion[i] - before.motion[i];
    }
    for (unsigned int r = 0; r < contact.n_time_samples() * contact.n_rigid_motions(); ++r)
      next->state.rigid[r] += after.state.rigid[r] - before.state.rigid[r];
    next->speed += to.speed - from.speed;
    next->memory = after.memory;
    other        = after;
  }
} // namespace ringmotor
