// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/stable_root.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <cstdint>

namespace ringmotor
{
  bool reduce_interval(const std::function<double(double)> &excess,
                       const std::pair<double, double> &one, const std::pair<double, double> &other,
                       const double narrow)
  {
    constexpr std::uintmax_t most_trials = 100;
    const auto &[low, high]              = std::minmax(one, other);
    std::uintmax_t n_trials              = most_trials;
    boost::math::tools::toms748_solve(
        excess, low.first, high.first, low.second, high.second,
        [&](const double a, const double b) { return std::abs(b - a) <= narrow; }, n_trials);
    return n_trials < most_trials;
  }
} // namespace ringmotor
