// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/block_compliance.h>
#include <ringmotor/motor/condensed_motor.h>

namespace ringmotor
{
  /** The length of a step of the steady state: that from which on each tooth is where another one
   * was, divided by the number of samples, or several of them joined. */
  struct SteadyStep
  {
    unsigned int n_samples = 1;
    unsigned int n_joined  = 1; ///< with one sample only
  };

  /** The teeth s of the steady state, n s = gcd(n, N) (mod N): what a tooth was T/P ago, its s-th
   * neighbour is now; see RingContact. */
  unsigned int steady_neighbour(const CondensedMotor &motor);

  /** s, from one sample to the next. */
  double step_length(const CondensedMotor &motor, const SteadyStep &step);

  /** A motor with inertia in its steady state. */
  struct SteadyDynamics
  {
    SteadyDynamics(const CondensedMotor &motor, const SteadyStep &step,
                   const RingDynamics &dynamics);

    const SteadyInertia inertia;
    const BlockCompliance compliance; ///< static and dynamic
  };
} // namespace ringmotor
