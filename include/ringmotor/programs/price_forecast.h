// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/log.h>
#include <ringmotor/points/torque_speed.h>

#include <chrono>

namespace ringmotor
{
  /**
   * Tells in advance what meshes and operating points may cost, from what the last ones did. The
   * seconds of a point are taken as proportional to (contact nodes * steps)^1.5.
   */
  class PriceForecast
  {
  public:
    explicit PriceForecast(Log &log) : log(log) {}

    /** Before interface mesh @p level is made: the motor and the points of the last one took these
     * seconds. */
    void before_mesh(const unsigned int level, const double motor_seconds,
                     const double point_seconds);
    /** Before points are computed; says nothing if they take little time. */
    void before_points(const CondensedMotor &motor, const CurveSetting &setting,
                       const unsigned int n_points);
    /** After each of them: tells how far the computation is. */
    void after_point(const CurvePoint &point);

  private:
    using Clock = std::chrono::steady_clock;
    static double seconds_since(const Clock::time_point time)
    {
      return std::chrono::duration<double>(Clock::now() - time).count();
    }

    Log &log;
    double effort             = 0.; ///< of a point: (contact nodes * steps)^1.5
    double seconds_per_effort = 0.; ///< at the last point
    unsigned int n_asked = 0, n_found = 0;
    Clock::time_point begin, told;
  };
} // namespace ringmotor
