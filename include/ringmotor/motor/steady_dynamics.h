// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/block_compliance.h>
#include <ringmotor/motor/condensed_motor.h>

namespace ringmotor
{
  /** The length of a step of the steady state: the time after which each tooth is where another one
   * was, divided by the number of time samples, or several of these steps joined. */
  struct SteadyStep
  {
    unsigned int n_samples = 1;
    unsigned int n_joined  = 1; ///< only with a single time sample
  };

  /** The shift s of the steady state, n s = gcd(n, N) (mod N): the state of a tooth T/P ago is that
   * of its s-th neighbour now; see RingContact. */
  unsigned int steady_neighbour(const CondensedMotor &motor);

  /** s, from one time sample to the next. */
  double step_length(const CondensedMotor &motor, const WaveAtNodes &wave, const SteadyStep &step);

  /** The dynamic compliance of a motor with inertia in its steady state. */
  struct SteadyDynamics
  {
    /** @param modes by_shapes() of the motor's modes */
    SteadyDynamics(const MotorInUse &motor, std::shared_ptr<const ModesByShapes> modes,
                   const SteadyStep &step, const RingDynamics &dynamics);

    const SteadyInertia inertia;
    const BlockCompliance compliance; ///< static and dynamic
  };
} // namespace ringmotor
