// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/torque_speed.h>

#include <vector>

namespace ringmotor
{
  /** Fractions of the stall torque at which the shape of a curve is sampled first. */
  const std::vector<double> &shares_for_shape();

  /**
   * Where a torque-speed curve is computed: at equal distances along it, in a plane of torque over
   * stall torque and 0.4 times speed over no-load speed, so that steep parts also get points. A
   * point is requested by its torque unless the relative speed falls faster than the relative
   * torque rises: then by its speed, which a given torque barely determines.
   *
   * @param shape points from no load (by torque) to stall (by speed), in this order
   * @param n_points at least two; the first is at no load, the last at stall
   */
  std::vector<PointRequest> points_along_curve(const std::vector<CurvePoint> &shape,
                                               unsigned int n_points);
} // namespace ringmotor
