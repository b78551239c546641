// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/step_history.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace ringmotor
{
  namespace
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();

    /** The sum of squares (N^2) of the differences of forces. */
    double distance(const StepEnd &a, const StepEnd &b)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < a.state.force.size(); ++i)
        sum += (a.state.force[i] - b.state.force[i]).norm_square();
      return sum;
    }

    /** The same from a state without forces. */
    double distance(const StepEnd &end)
    {
      double sum = 0.;
      for (const PointVector &force : end.state.force)
        sum += force.norm_square();
      return sum;
    }
  } // namespace

  StepEnd turned(const StepEnd &end, const unsigned int by, const unsigned int n_teeth)
  {
    StepEnd result  = end;
    const auto turn = [&](std::vector<PointVector> &of_points)
    {
      const std::size_t n_moved = of_points.size() / n_teeth * (by % n_teeth);
      std::rotate(of_points.begin(), of_points.end() - n_moved, of_points.end());
    };
    turn(result.state.force);
    turn(result.motion);
    // The rise is followed by cosine and sine parts of motions with one wave around the ring.
    const std::complex<double> phase = std::polar(1., 2. * dealii::numbers::PI * by / n_teeth);
    std::vector<double> &rigid       = result.state.rigid;
    for (unsigned int r = 1; r + 1 < rigid.size(); r += 2)
    {
      const std::complex<double> part = phase * std::complex<double>(rigid[r], rigid[r + 1]);
      rigid[r]                        = part.real();
      rigid[r + 1]                    = part.imag();
    }
    return result;
  }

  StepHistory::StepHistory(const CondensedMotor &motor, const Warp &warp)
      : period(motor.period()), n_teeth(motor.n_teeth),
        repetition(repetition_of({motor.n_waves, motor.n_teeth, warp.n_waves}))
  {
  }

  void StepHistory::add(StepEnd end)
  {
    // With more steps than this in a period, extrapolation is accurate.
    constexpr std::size_t most_ends = 120;
    const double missed             = by_repetition ? distance(by_repetition->end, end) : infinite;
    if (by_repetition)
      repeats = missed < distance(by_extrapolation, end);
    if (missed <= std::pow(repetition_tolerance, 2) * distance(end))
      repeated_from = std::min(repeated_from, end.time - by_repetition->since);
    else
      repeated_from = infinite;
    if (ends.size() == most_ends)
      ends.pop_front();
    ends.push_back(std::move(end));
  }

  const StepEnd &StepHistory::predict(const double length)
  {
    by_extrapolation = extrapolated(length);
    by_repetition    = repeated(length);
    return by_repetition && repeats ? by_repetition->end : by_extrapolation;
  }

  StepEnd StepHistory::extrapolated(const double length) const
  {
    StepEnd next = last();
    // A state at rest is no basis for extrapolation.
    const StepEnd *before = ends.size() > 1 ? &ends[ends.size() - 2] : nullptr;
    if (!before || before->motion.empty())
    {
      next.motion.clear();
      return next;
    }
    const double share = length / next.length;
    for (unsigned int i = 0; i < next.motion.size(); ++i)
    {
      PointVector &force = next.state.force[i], &motion = next.motion[i];
      const double gap = motion[0] + share * (motion[0] - before->motion[i][0]);
      force += share * (force - before->state.force[i]);
      if (force[0] <= 0.)
        force = 0.;
      motion *= share; // slips
      motion[0] = gap;
    }
    for (unsigned int r = 0; r < next.state.rigid.size(); ++r)
      next.state.rigid[r] += share * (next.state.rigid[r] - before->state.rigid[r]);
    return next;
  }

  std::optional<StepHistory::Repeated> StepHistory::repeated(const double length) const
  {
    constexpr double tolerance = 0.05; // of a step, the largest time shift of the wave
    constexpr double rounding  = 1e-3; // of it
    const double now = last().time + length, part = period / repetition.n_parts;
    const StepEnd *best  = nullptr;
    unsigned int n_parts = 0; // since that step
    double least         = tolerance * length;
    for (auto end = ends.rbegin(); end != ends.rend(); ++end)
    {
      const double since  = now - end->time;
      const auto n_since  = static_cast<unsigned int>(std::lround(since / part));
      const double missed = std::abs(since - n_since * part);
      if (end->motion.empty() || std::abs(end->length - length) > tolerance * length ||
          n_since == 0 || missed > least - rounding * tolerance * length)
        continue;
      best    = &*end;
      n_parts = n_since;
      least   = missed;
    }
    if (!best)
      return {};
    return Repeated{turned(*best, n_parts * repetition.n_teeth % n_teeth, n_teeth), n_parts * part};
  }
} // namespace ringmotor
