// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/operation.h>

#include <functional>

namespace ringmotor
{
  /** What a contact point remembers of the last step. */
  struct FrictionMemory
  {
    bool stuck     = false; ///< it stuck at the end of the last step
    double slipped = 0.;    ///< m, how far it has slipped since it stuck last or came into contact
  };

  /** A coefficient of friction and how it changes with the slip of the step. */
  struct FrictionCoefficient
  {
    double value      = 0.;
    double derivative = 0.; ///< 1/m, by the length of the slip
  };

  /**
   * The coefficient of friction of a point that slips by @p slip (m, not negative) in a step of
   * @p time_step (s); without slip it is the limit up to which the point sticks.
   *
   * - coulomb: mu_d always;
   * - static_dynamic (eqs. 3-6 of Maeno 1992): mu_s for a point that stuck at the end of the last
   *   step, mu_d for one that slipped. That a point which exceeds mu_s within the step falls to
   *   mu_d is the business of the caller: the law as a jump has no derivative;
   * - velocity: mu_d + (mu_s - mu_d) exp(-v/v_c), v = slip/time_step;
   * - slip_weakening: from mu_s to mu_d linearly while the point slips the weakening length.
   */
  FrictionCoefficient friction_coefficient(const Friction &friction, const FrictionMemory &memory,
                                           const double slip, const double time_step);

  /** The coefficient of friction of a point for a slip (m, not negative). */
  using PointFriction = std::function<FrictionCoefficient(unsigned int point, double slip)>;
} // namespace ringmotor
