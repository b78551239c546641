// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/quantities/frequency_error.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  Estimate frequency_estimate(const std::vector<FrequencySample> &samples)
  {
    Assert(!samples.empty(), dealii::ExcInternalError());
    const FrequencySample &best = samples.back();

    const double largest = best.degree <= 2 ? 16. : best.degree == 3 ? 4.6 : 9.2;
    double kappa         = largest;
    for (const FrequencySample &sample : samples)
      // Two meshes of one degree show the slope, if they differ enough. Its own uncertainty bounds
      // the gain.
      if (sample.degree == best.degree && sample.indicator > 1.5 * best.indicator)
      {
        const double eigenvalue_excess = std::pow(sample.frequency / best.frequency, 2) - 1.;
        const double slope             = eigenvalue_excess / (sample.indicator - best.indicator);
        kappa                          = std::clamp(1.2 * slope, 0.65 * largest, largest);
      }
    const double half_width = 0.25 * kappa * best.indicator * best.frequency;
    return {best.frequency - half_width, half_width};
  }

  Estimate shape_estimate(const double value, const double earlier, const FrequencySample &sample,
                          const FrequencySample &earlier_sample,
                          const double relative_frequency_error)
  {
    const double ratio  = std::min(0.8, std::sqrt(sample.indicator / earlier_sample.indicator));
    const double change = 2. * std::abs(value - earlier) * ratio / (1. - ratio);
    return {value, std::max(change, 2. * relative_frequency_error * std::abs(value))};
  }
} // namespace ringmotor
