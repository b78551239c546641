// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/points/curve_setting.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numeric>
#include <sstream>

namespace ringmotor
{
  std::string CurveSetting::text() const
  {
    std::ostringstream text;
    text << std::setprecision(std::numeric_limits<double>::max_digits10) << "interface mesh "
         << level << ", step " << n_joined << "/" << n_parts;
    if (wave_factor != 1.)
      text << ", wave times " << wave_factor;
    text << (modes == ModesInUse::coarse               ? ", coarse modes"
             : modes == ModesInUse::of_other_harmonics ? ", modes of other harmonics"
                                                       : "")
         << (has_other_scheme ? ", other scheme" : "") << (has_drive_error ? ", other drive" : "");
    return text.str();
  }

  CurveSetting CurveSetting::halved() const
  {
    CurveSetting halved = *this;
    if (n_joined > 1) // a power of two
      halved.n_joined /= 2;
    else
      halved.n_parts *= 2;
    return halved;
  }

  CurveSetting CurveSetting::doubled() const
  {
    CurveSetting doubled = *this;
    if (n_parts % 2 == 0)
      doubled.n_parts /= 2;
    else
      doubled.n_joined *= 2;
    return doubled;
  }

  namespace
  {
    /** Teeth after which the motion repeats. */
    unsigned int teeth_that_differ(const Motor &motor)
    {
      return motor.n_teeth / std::gcd(motor.n_waves, motor.n_teeth);
    }

    constexpr unsigned int few_marched_steps = 30; // in a period; each is expensive

    /** In a period of the steady state: enough for differences between meshes to be known to a
     * fraction of the target. */
    unsigned int steps_to_compare_with(const Parameters &parameters)
    {
      // With inertia, bodies vibrate many times in a period.
      const bool has_inertia        = motor_model(parameters).has_inertia();
      const unsigned int few        = has_inertia ? 80 : 40;
      constexpr unsigned int enough = 360;
      if (parameters.accuracy.mode == AccuracyMode::fixed)
        return few;
      // Long steps make contact begin and end in jumps, on each mesh at other places: with 90 steps
      // speeds scatter by 0.4 %, with 180 by half of that; several times as much with inertia.
      const double wanted = (has_inertia ? 5. : 1.2) / parameters.accuracy.strictest_target();
      return std::clamp(static_cast<unsigned int>(wanted), few, enough);
    }
  } // namespace

  StepChoice::StepChoice(const Parameters &parameters, const double period)
      : is_marched(ringmotor::is_marched(parameters)),
        is_fixed(parameters.accuracy.mode == AccuracyMode::fixed),
        n_snapshots(parameters.time.n_snapshots), few_steps(steps_to_compare_with(parameters)),
        n_undivided(is_marched ? period / parameters.time.time_step
                               : teeth_that_differ(parameters.motor))
  {
  }

  unsigned int StepChoice::parts_for(const unsigned int n_steps) const
  {
    return std::ceil(n_steps / n_undivided);
  }

  CurveSetting StepChoice::plain(const unsigned int level) const
  {
    // As given step lengths are rounded, slightly fewer steps suffice.
    constexpr double nearly = 0.99;
    const double few        = is_marched ? nearly * few_marched_steps : few_steps;
    CurveSetting plain{level};
    if (!is_marched)
      plain.n_parts = parts_for(few_steps);
    while (2 * plain.n_joined * few <= n_undivided)
      plain.n_joined *= 2;
    return plain;
  }

  CurveSetting StepChoice::longest(const unsigned int level) const
  {
    CurveSetting longest = plain(level);
    while (longest.n_parts % 2 == 0)
      longest = longest.doubled();
    return longest;
  }

  unsigned int StepChoice::first_parts() const
  {
    if (is_marched)
      return 1;
    if (is_fixed)
      return n_snapshots;
    const CurveSetting plain_steps = plain(0);
    if (plain_steps.n_parts % 2 == 0) // twice as long ones show the error
      return std::max(plain_steps.n_parts, n_snapshots);
    return std::max({plain_steps.n_joined > 1 ? 1 : plain_steps.n_parts + 1,
                     parts_for(2 * few_steps), n_snapshots});
  }

  unsigned int StepChoice::most_parts() const
  {
    constexpr double most_steps = 11520.; // in a period
    return std::max(1., std::ceil(most_steps / n_undivided));
  }
} // namespace ringmotor
