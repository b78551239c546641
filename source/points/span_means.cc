// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/step_history.h>
#include <ringmotor/points/point_quantities.h>
#include <ringmotor/points/span_means.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace ringmotor
{
  namespace
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();

    /** The first of the later three quarters of some values. */
    std::size_t first_later(const std::size_t n)
    {
      return n - 3 * (n / 4);
    }
  } // namespace

  double remaining_change(const std::vector<double> &means)
  {
    constexpr double slowest = 0.9; // ratio still distinguishable from no convergence
    const std::size_t n      = means.size();
    if (n < 3)
      return infinite;
    const double before = std::abs(means[n - 2] - means[n - 3]),
                 last   = std::abs(means[n - 1] - means[n - 2]),
                 ratio  = last < slowest * before ? last / before : slowest;
    return std::max({before, last, last * ratio / (1. - ratio)});
  }

  LaterMean later_mean(const std::vector<double> &values)
  {
    constexpr std::size_t enough = 12, n_batches = 3;
    constexpr double of_student = 4.303; // two degrees of freedom
    const std::size_t n = values.size(), length = n / (n_batches + 1);
    if (n < enough)
      return {0., infinite};
    std::array<double, n_batches> means;
    auto begin = values.begin() + first_later(n);
    for (double &mean : means)
    {
      mean = std::accumulate(begin, begin + length, 0.) / length;
      begin += length;
    }
    LaterMean later;
    later.mean     = std::accumulate(means.begin(), means.end(), 0.) / n_batches;
    double squares = 0.;
    for (const double mean : means)
      squares += std::pow(mean - later.mean, 2);
    later.error = of_student * std::sqrt(squares / (n_batches - 1) / n_batches);
    return later;
  }

  void SpanMeans::add(CurvePoint span, const bool now_repeats)
  {
    repeats                 = now_repeats;
    const PointError values = values_of(span);
    for (const PointQuantity &quantity : point_quantities())
      if (quantity.has_own_error())
        by_quantity[quantity.name].push_back(values[quantity.name]);
    spans.push_back(std::move(span));
  }

  PointError SpanMeans::error_of_last() const
  {
    // Values change in proportion to forces; their differences, losses for instance, are smaller.
    constexpr double of_values = 10.;
    if (repeats)
      return of_values * StepHistory::repetition_tolerance * sizes_of(last());
    PointError error;
    for (const auto &[quantity, values] : by_quantity)
      error[quantity] = remaining_change(values);
    return error;
  }

  CurvePoint SpanMeans::later() const
  {
    const std::size_t first = first_later(spans.size()), n = spans.size() - first;
    std::vector<OperatingPoint> results;
    CurvePoint point = last();
    point.rotor_energies.assign(point.rotor_energies.size(), 0.);
    point.rotor_power = 0.;
    for (std::size_t i = first; i < spans.size(); ++i)
    {
      results.push_back(spans[i].result);
      point.rotor_power += spans[i].rotor_power / n;
      for (std::size_t j = 0; j < point.rotor_energies.size(); ++j)
        point.rotor_energies[j] += spans[i].rotor_energies[j] / n;
    }
    point.result = mean(results, std::vector<double>(n, 1.));
    return point;
  }

  PointError SpanMeans::error_of_later() const
  {
    PointError error;
    for (const auto &[quantity, values] : by_quantity)
      error[quantity] = later_mean(values).error;
    return error;
  }
} // namespace ringmotor
