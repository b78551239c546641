// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/steady_dynamics.h>

namespace ringmotor
{
  unsigned int steady_neighbour(const CondensedMotor &motor)
  {
    const unsigned int n = motor.n_teeth, fold = motor.n_repeats();
    unsigned int s = 0;
    while (motor.n_waves * s % n != fold % n)
      ++s;
    return s % (n / fold);
  }

  double step_length(const CondensedMotor &motor, const SteadyStep &step)
  {
    return motor.period() * step.n_joined / (motor.n_teeth / motor.n_repeats() * step.n_moments);
  }

  namespace
  {
    std::vector<unsigned int> places(const CondensedMotor &motor, const SteadyStep &step)
    {
      const unsigned int n_sectors = motor.n_teeth / motor.n_repeats(), s = steady_neighbour(motor),
                         n_places = n_sectors * step.n_moments;
      std::vector<unsigned int> places(n_places);
      for (unsigned int m = 0; m < step.n_moments; ++m)
        for (unsigned int n_steps = 0; n_steps < n_sectors; ++n_steps)
          places[m * n_sectors + s * n_steps % n_sectors] =
              (m + step.n_moments * (n_sectors - n_steps)) % n_places;
      return places;
    }
  } // namespace

  SteadyDynamics::SteadyDynamics(const CondensedMotor &motor, const SteadyStep &step,
                                 const RingDynamics &dynamics)
      : inertia(motor.rotor_modes, motor.n_waves, motor.n_teeth, motor.period(),
                motor.n_teeth / motor.n_repeats() * step.n_moments, step_length(motor, step),
                dynamics),
        place(places(motor, step)),
        // From tooth to tooth it is as many instants everywhere.
        compliance(motor.repeating().spread(place.size(), place[1 % place.size()]) +
                   inertia.compliance())
  {
    if (compliance.table_size() <= RingCompliance::largest_table)
      compliance.tabulate();
  }
} // namespace ringmotor
