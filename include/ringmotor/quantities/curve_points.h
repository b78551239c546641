// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/quantities/torque_speed.h>

#include <vector>

namespace ringmotor
{
  /** Shares of the stall torque at which the shape of a curve is looked at first. */
  const std::vector<double> &shares_for_shape();

  /**
   * Where a torque-speed curve is computed: at equal distances along it, in a plane of torque over
   * stall torque and 0.4 of speed over no-load speed, so that steep parts get some points, too. A
   * point is asked for by its torque unless the speed's share falls faster than the torque's rises:
   * then by its speed, as a given torque hardly tells it.
   *
   * @param shape points from no load (by torque) to stall (by speed), in this order
   * @param n_points at least two; the first is without load, the last stalls
   */
  std::vector<PointRequest> points_along_curve(const std::vector<CurvePoint> &shape,
                                               unsigned int n_points);
} // namespace ringmotor
