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

    double kappa = std::max(0.15, 0.3 * best.degree - 0.45);
    for (const FrequencySample &sample : samples)
      // Two meshes of one degree show the slope, if they differ enough.
      if (sample.degree == best.degree && sample.indicator > 1.5 * best.indicator)
      {
        const double eigenvalue_excess = std::pow(sample.frequency / best.frequency, 2) - 1.;
        kappa = std::max(kappa, eigenvalue_excess / (sample.indicator - best.indicator));
      }
    const double half_width = 0.25 * kappa * best.indicator * best.frequency;
    return {best.frequency - half_width, half_width};
  }

  Estimate shape_estimate(const double value, const double earlier, const double indicator,
                          const double earlier_indicator)
  {
    // The shape converges like the square root of the energy at worst.
    const double ratio = std::min(0.8, std::sqrt(indicator / earlier_indicator));
    return {value, 2. * std::abs(value - earlier) * ratio / (1. - ratio)};
  }
} // namespace ringmotor
