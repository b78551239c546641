// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/friction_law.h>
#include <ringmotor/motor/steady_memory.h>

#include <algorithm>

namespace ringmotor
{
  std::vector<FrictionMemory> travelled(const RingContact &contact, const StepState &solution)
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

  SteadyMemory::SteadyMemory(const RingContact &contact, const Friction &friction,
                             std::vector<FrictionMemory> start)
      : contact(contact), friction(friction), memory(std::move(start)), later(contact.n_points()),
        n_gains(contact.n_points())
  {
    memory.resize(contact.n_points());
    for (unsigned int point = 0; point < contact.n_points(); ++point)
    {
      later[contact.earlier(point)] = point;
      n_gains[point]                = memory[point].stuck ? 1 : 0;
    }
  }

  std::vector<unsigned int> SteadyMemory::along_paths(const StepState &solution) const
  {
    std::vector<unsigned int> order;
    std::vector<char> is_listed(contact.n_points(), false);
    const auto follow = [&](unsigned int point)
    {
      for (; !is_listed[point] && solution.status[point] != PointStatus::open; point = later[point])
      {
        is_listed[point] = true;
        order.push_back(point);
      }
    };
    for (unsigned int point = 0; point < contact.n_points(); ++point)
      if (solution.status[contact.earlier(point)] == PointStatus::open)
        follow(point);
    for (unsigned int point = 0; point < contact.n_points(); ++point) // always touch
      follow(point);
    for (unsigned int point = 0; point < contact.n_points(); ++point)
      if (!is_listed[point])
        order.push_back(point);
    return order;
  }

  unsigned int SteadyMemory::n_alternating() const
  {
    const FrictionLawBase &law = law_of(friction);
    if (!law.may_wander())
      return 0;
    const auto is_same = [&](const FrictionMemory &one, const FrictionMemory &other)
    { return law.agree(friction, one, other); };
    for (unsigned int period = 1; period <= earlier.size(); ++period)
      if (std::equal(memory.begin(), memory.end(), earlier[earlier.size() - period].begin(),
                     is_same))
        return period;
    return n_solutions >= enough_to_wander ? longest_period : 0;
  }

  bool SteadyMemory::settled(const StepState &solution)
  {
    ++n_solutions;
    earlier.push_back(memory);
    if (earlier.size() > longest_period)
      earlier.erase(earlier.begin());
    constexpr unsigned char most_gains          = 3;
    const FrictionLawBase &law                  = law_of(friction);
    const std::vector<FrictionMemory> found_now = travelled(contact, solution);
    const auto would_stick                      = [&](const unsigned int point)
    {
      const PointVector &force = solution.state.force[point];
      const double limit =
          friction_coefficient(friction, memory[point], 0., contact.time_step()).value;
      return tangential_norm(force) <= (1. + 1e-9) * limit * force[0];
    };
    std::vector<char> sticks(contact.n_points()); // with the memory that it will have
    for (unsigned int point = 0; point < contact.n_points(); ++point)
      sticks[point] = solution.status[point] == PointStatus::stick;
    bool all_agreed       = true;
    unsigned int on_trust = 0;
    for (const unsigned int point : along_paths(solution))
    {
      const bool had = memory[point].stuck;
      const FrictionMemory found{sticks[contact.earlier(point)] != 0, found_now[point].slipped};
      const bool agreed = law.settle(friction, found, solution.status[point],
                                     n_gains[point] >= most_gains, memory[point]);
      const bool gains  = memory[point].stuck && !had;
      if (gains)
        ++n_gains[point];
      else if (had && solution.status[point] == PointStatus::slip)
        n_gains[point] = most_gains; // its force exceeds even the static limit
      on_trust      = gains && solution.status[point] == PointStatus::slip ? on_trust + 1 : 0;
      sticks[point] = solution.status[point] == PointStatus::stick
                          ? would_stick(point)
                          : on_trust > 0 && on_trust < reach;
      all_agreed    = all_agreed && agreed;
    }
    reach *= 2;
    return all_agreed;
  }
} // namespace ringmotor
