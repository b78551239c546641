// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/steady_dynamics.h>

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

  double step_length(const CondensedMotor &motor, const WaveAtNodes &wave, const SteadyStep &step)
  {
    return wave.period() * step.n_joined / (motor.n_teeth / motor.n_repeats() * step.n_samples);
  }

  namespace
  {
    /** The instant of the common history at each tooth, by time sample and tooth. */
    std::vector<unsigned int> instants(const CondensedMotor &motor, const SteadyStep &step)
    {
      const unsigned int n_sectors = motor.n_teeth / motor.n_repeats(), s = steady_neighbour(motor),
                         n_instants = n_sectors * step.n_samples;
      std::vector<unsigned int> instants(n_instants);
      for (unsigned int m = 0; m < step.n_samples; ++m)
        for (unsigned int n_steps = 0; n_steps < n_sectors; ++n_steps)
          instants[m * n_sectors + s * n_steps % n_sectors] =
              (m + step.n_samples * (n_sectors - n_steps)) % n_instants;
      return instants;
    }
  } // namespace

  SteadyDynamics::SteadyDynamics(const MotorInUse &motor,
                                 std::shared_ptr<const ModesByShapes> modes, const SteadyStep &step,
                                 const RingDynamics &dynamics)
      : inertia(std::move(modes), motor.bodies.n_waves, motor.bodies.n_teeth, motor.wave.period(),
                motor.bodies.n_teeth / motor.bodies.n_repeats() * step.n_samples,
                step_length(motor.bodies, motor.wave, step), dynamics),
        compliance(motor.bodies.repeating(), step.n_samples, inertia.compliance(),
                   instants(motor.bodies, step))
  {
  }
} // namespace ringmotor
