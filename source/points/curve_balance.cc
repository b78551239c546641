// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/curve_search.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  namespace
  {
    /** Number of parts expected to bring a power imbalance of @p excess times its limit below it:
     * it falls with the square of the step, but not regularly. */
    unsigned int parts_for_balance(const unsigned int n_parts, const double excess)
    {
      constexpr double margin = 1.2, most_at_once = 8.;
      const double factor = std::clamp(margin * std::sqrt(excess), 4. / 3., most_at_once);
      return std::ceil(factor * n_parts);
    }

    std::string text_of(const PointRequest &request)
    {
      const bool is_torque = request.control == Control::torque;
      return "the point at " + short_text((is_torque ? 1e3 : 30. / M_PI) * request.value) +
             (is_torque ? " mN m" : " rpm");
    }
  } // namespace

  bool CurveSearch::powers_balance()
  {
    const unsigned int most = steps.most_parts();
    bool is_balanced        = true;
    for (const unsigned int i : all_requests())
    {
      const OperatingPoint &result = point_of({reached_level, n_parts[i]}, i).result;
      const double excess          = result.power_imbalance() / OperatingPoint::largest_imbalance;
      if (excess > 1. && n_parts[i] < most)
      {
        foresee_balance(i, excess);
        shorten_step(i, std::min(most, parts_for_balance(n_parts[i], excess)));
        is_balanced = false;
      }
    }
    return is_balanced;
  }

  void CurveSearch::foresee_balance(const unsigned int request, const double excess)
  {
    // The imbalance falls irregularly: only a large change of the step shows its order.
    constexpr double large = 16., hopeless = 4.;
    const double parts = n_parts[request];
    const auto [found, is_first] =
        first_imbalances.insert({{reached_level, request}, {parts, excess}});
    const auto &[first_parts, first_excess] = found->second;
    if (is_first || parts < large * first_parts)
      return;
    const double order = std::log(first_excess / excess) / std::log(parts / first_parts);
    if (order > 0. && parts * std::pow(excess, 1. / order) < hopeless * steps.most_parts())
      return;
    const double limit = OperatingPoint::largest_imbalance;
    throw ComputationError(
        "the powers of " + text_of(requests[request]) + " balance within " +
        short_text(limit * excess) + " of the power that is exchanged, allowed: " +
        short_text(limit) + "; with steps " + short_text(parts / first_parts) +
        " times as long it was " + short_text(limit * first_excess) +
        ", so that no steps short enough can be expected; choose other Loading/Values");
  }
} // namespace ringmotor
