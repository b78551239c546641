// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/summary.h>
#include <ringmotor/points/curve_search.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** `50.00 mN m: 82.45 +- 0.52 rpm, friction loss ...` */
  std::string describe(const CurvePoint &point);

  /** Adds the quantities of operating points and the certificates of their solutions. */
  void add_points(Summary &summary, const std::vector<CurvePoint> &points);
} // namespace ringmotor
