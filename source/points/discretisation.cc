// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/warp.h>
#include <ringmotor/parameters/accuracy_budget.h>
#include <ringmotor/points/discretisation.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace ringmotor
{
  Steps Steps::halved() const
  {
    // Joined steps are a power of two in number.
    return n_joined > 1 ? Steps{n_parts, n_joined / 2} : Steps{2 * n_parts, n_joined};
  }

  Steps Steps::doubled() const
  {
    return n_parts % 2 == 0 ? Steps{n_parts / 2, n_joined} : Steps{n_parts, 2 * n_joined};
  }

  bool Discretisation::operator<(const Discretisation &other) const
  {
    const auto numbers = [](const Discretisation &of)
    {
      return std::make_tuple(of.level, of.modes_level, of.steps.n_parts, of.steps.n_joined,
                             of.variation ? of.variation->name : std::string());
    };
    return numbers(*this) < numbers(other);
  }

  std::string Discretisation::text() const
  {
    return "interface mesh " + std::to_string(level) + ", step " + std::to_string(steps.n_joined) +
           "/" + std::to_string(steps.n_parts) + (variation ? ", " + variation->name : "");
  }

  namespace
  {
    /** Teeth after which the motion repeats. */
    unsigned int teeth_that_differ(const Motor &motor)
    {
      return motor.n_teeth / std::gcd(motor.n_waves, motor.n_teeth);
    }

    unsigned int steps_to_compare_with(const Parameters &parameters)
    {
      constexpr unsigned int few_marched = 30; // each is expensive
      if (is_marched(parameters))
        return few_marched;
      // With inertia, bodies vibrate many times in a period.
      const bool has_inertia        = motor_model(parameters).has_inertia();
      const unsigned int few        = has_inertia ? 80 : 40;
      constexpr unsigned int enough = 360;
      if (parameters.accuracy.mode == AccuracyMode::fixed)
        return few;
      const double wanted = AccuracyBudget(parameters.accuracy).steps_to_compare_with(has_inertia);
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

  Steps StepChoice::at_least(const double n_steps) const
  {
    constexpr double nearly = 0.99;
    const double in_period  = is_marched ? n_undivided * n_snapshots : n_undivided;
    Steps steps;
    steps.n_parts = std::max(1., std::ceil(nearly * n_steps / in_period));
    while (2 * steps.n_joined * nearly * n_steps <= in_period)
      steps.n_joined *= 2;
    return steps;
  }

  Steps StepChoice::plain() const
  {
    if (!is_marched)
      return at_least(few_steps);
    Steps plain   = at_least(few_steps * n_snapshots);
    plain.n_parts = 1; // no shorter than the user wants them
    return plain;
  }

  Steps StepChoice::of_meshes() const
  {
    return is_marched ? Steps{first_parts()} : plain();
  }

  Steps StepChoice::longest() const
  {
    Steps longest = plain();
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
    const Steps compared = plain();
    if (compared.are_compared_with_longer())
      return std::max(compared.n_parts, n_snapshots);
    return std::max({compared.n_joined > 1 ? 1 : compared.n_parts + 1,
                     at_least(2 * few_steps).n_parts, n_snapshots});
  }

  unsigned int StepChoice::most_parts() const
  {
    constexpr double most_steps = 11520.; // in a period
    return std::max(1., std::ceil(most_steps / n_undivided));
  }

  Parameters with_parts_of_a_step(Parameters parameters, const unsigned int n_parts)
  {
    unsigned int &n_snapshots = parameters.time.n_snapshots;
    n_snapshots               = (is_marched(parameters) ? n_snapshots : 1) * n_parts;
    return parameters;
  }
} // namespace ringmotor
