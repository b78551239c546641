// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/power_balance.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  unsigned int PowerBalance::parts_for(const CurvePoint &point, const unsigned int level,
                                       const unsigned int n_parts)
  {
    const double excess = point.result.power_imbalance() / OperatingPoint::largest_imbalance;
    if (excess <= 1. || n_parts >= most_parts)
      return n_parts;
    foresee(point, level, n_parts, excess);
    // The imbalance falls with the square of the step, but not regularly.
    constexpr double margin = 1.2, most_at_once = 8.;
    const double factor = std::clamp(margin * std::sqrt(excess), 4. / 3., most_at_once);
    return std::min<unsigned int>(most_parts, std::ceil(factor * n_parts));
  }

  void PowerBalance::foresee(const CurvePoint &point, const unsigned int level,
                             const unsigned int n_parts, const double excess)
  {
    // Only a large change of the step shows the order of the imbalance.
    constexpr double large = 16., hopeless = 4.;
    const double parts           = n_parts;
    const auto [found, is_first] = first.insert({{level, point.request}, {parts, excess}});
    const auto &[first_parts, first_excess] = found->second;
    if (is_first || parts < large * first_parts)
      return;
    const double order = std::log(first_excess / excess) / std::log(parts / first_parts);
    if (order > 0. && parts * std::pow(excess, 1. / order) < hopeless * most_parts)
      return;
    const double limit   = OperatingPoint::largest_imbalance;
    const bool is_torque = point.request.control == Control::torque;
    throw ComputationError(
        "the powers of the point at " +
        short_text((is_torque ? 1e3 : 30. / M_PI) * point.request.value) +
        (is_torque ? " mN m" : " rpm") + " balance within " + short_text(limit * excess) +
        " of the power that is exchanged, allowed: " + short_text(limit) + "; with steps " +
        short_text(parts / first_parts) + " times as long it was " +
        short_text(limit * first_excess) +
        ", so that no steps short enough can be expected; choose other Loading/Values");
  }
} // namespace ringmotor
