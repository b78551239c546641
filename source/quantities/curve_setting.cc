// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/quantities/curve_setting.h>

#include <algorithm>
#include <numeric>

namespace ringmotor
{
  namespace
  {
    /** Teeth after which all repeats itself: steps in a period of the wave, undivided. */
    unsigned int teeth_that_differ(const Motor &motor)
    {
      return motor.n_teeth / std::gcd(motor.n_waves, motor.n_teeth);
    }

    /** Parts of a step so that a period has so many steps or more. */
    unsigned int parts_for(const Motor &motor, const unsigned int n_steps)
    {
      return (n_steps - 1 + teeth_that_differ(motor)) / teeth_that_differ(motor);
    }

    constexpr unsigned int few_steps = 40, many_steps = 80; // in a period
  }                                                         // namespace

  CurveSetting CurveSetting::halved() const
  {
    CurveSetting halved = *this;
    if (n_joined > 1) // a power of two
      halved.n_joined /= 2;
    else
      halved.n_parts *= 2;
    return halved;
  }

  CurveSetting plain_setting(const Parameters &parameters, const unsigned int level)
  {
    CurveSetting plain{level};
    if (is_marched(parameters))
      return plain;
    plain.n_parts = parts_for(parameters.motor, few_steps);
    while (2 * plain.n_joined * few_steps <= teeth_that_differ(parameters.motor))
      plain.n_joined *= 2;
    return plain;
  }

  unsigned int parts_to_start_with(const Parameters &parameters)
  {
    if (is_marched(parameters))
      return 1;
    if (parameters.accuracy.mode == AccuracyMode::fixed)
      return parameters.time.n_snapshots;
    const CurveSetting plain = plain_setting(parameters, 0);
    return std::max({plain.n_joined > 1 ? 1 : plain.n_parts + 1,
                     parts_for(parameters.motor, many_steps), parameters.time.n_snapshots});
  }

  unsigned int most_parts(const Parameters &parameters, const CondensedMotor &motor)
  {
    constexpr double most_steps = 11520.; // in a period
    const double n_steps        = is_marched(parameters)
                                      ? motor.period() / parameters.time.time_step
                                      : static_cast<double>(teeth_that_differ(parameters.motor));
    return std::max(1., std::ceil(most_steps / n_steps));
  }
} // namespace ringmotor
