// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/wave/frequency_error.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  Estimate frequency_estimate(const FrequencySample &sample)
  {
    const double kappa = sample.degree <= 2 ? 1.1 : sample.degree == 3 ? 3.3 : 2.5;
    // Far too coarse meshes show only that a frequency is not negative.
    const double half_width = std::min(0.25 * kappa * sample.indicator, 0.5) * sample.frequency;
    return {sample.frequency - half_width, half_width, by_body_mesh};
  }

  Estimate shape_estimate(const double value, const double earlier, const FrequencySample &sample,
                          const FrequencySample &earlier_sample,
                          const double relative_frequency_error)
  {
    const double progress =
        frequency_estimate(sample).error() / frequency_estimate(earlier_sample).error();
    if (progress > 0.99) // no progress: the error is unknown
      return {value, std::abs(value), by_body_mesh};
    const double ratio  = std::min(0.8, std::sqrt(progress));
    const double change = 2. * std::abs(value - earlier) * ratio / (1. - ratio);
    return {value, std::max(change, 2. * relative_frequency_error * std::abs(value)), by_body_mesh};
  }
} // namespace ringmotor
