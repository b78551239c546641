// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/balance/drive.h>
#include <ringmotor/output/summary.h>

#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** An operating point and where its energy goes. */
  struct PointLosses
  {
    CurvePoint point;
    LossBudget budget;
    std::optional<DrivePoint> drive = {}; ///< with a piezoelectric ceramic
  };

  /** `50.00 mN m: output 432.1 +- 2.6 mW, losses ..., efficiency 39.9 +- 0.4 %` */
  std::string describe(const PointLosses &losses);

  /** `losses.csv`: the parts of the loss at each operating point, in mW. */
  void write_losses(const std::string &path, const std::vector<PointLosses> &points);

  /** `efficiency.csv`: input and output power at each operating point. */
  void write_efficiency(const std::string &path, const std::vector<PointLosses> &points);

  /** `drive.csv`: voltage, current and electrical power at each operating point. */
  void write_drive(const std::string &path, const std::vector<PointLosses> &points);

  /** Adds the quantities of the points to a summary, and the certificates of their balance.
   * @param seconds spent on the losses of a point */
  void add_losses(Summary &summary, const std::vector<PointLosses> &points, const double seconds);
} // namespace ringmotor
