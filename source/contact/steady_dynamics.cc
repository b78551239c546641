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
    /** The steady state as a ring of instants: one sector further is as many instants earlier as
     * steps from tooth to tooth lead there. */
    RingCompliance over_time(const CondensedMotor &motor, const SteadyStep &step)
    {
      const RingCompliance &at_once = motor.repeating();
      const unsigned int n_sectors = at_once.n_sectors(), s = steady_neighbour(motor);
      unsigned int n_steps = 0;
      while (n_sectors > 1 && n_steps * s % n_sectors != 1)
        ++n_steps;
      return at_once.spread(n_sectors * step.n_moments, step.n_moments * (n_sectors - n_steps));
    }
  } // namespace

  SteadyDynamics::SteadyDynamics(const CondensedMotor &motor, const SteadyStep &step,
                                 const RingDynamics &dynamics)
      : inertia(motor.rotor_modes, motor.n_waves, motor.n_teeth, motor.period(),
                motor.n_teeth / motor.n_repeats() * step.n_moments, step_length(motor, step),
                dynamics),
        compliance(over_time(motor, step) + inertia.compliance())
  {
    if (compliance.table_size() <= RingCompliance::largest_table)
      compliance.tabulate();
  }
} // namespace ringmotor
