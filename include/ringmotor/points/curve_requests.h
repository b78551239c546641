// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/measured_points.h>
#include <ringmotor/points/point_table.h>
#include <ringmotor/points/quantity_scales.h>

#include <vector>

namespace ringmotor
{
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

  /** How many points apart the measured ones of a curve are at most, see MeasuredPoints: one if
   * there are up to five points, which measures all of them, four from eleven points on. */
  unsigned int spacing_along_curve(const unsigned int n_points);

  /**
   * Which operating points a search looks for: those that `Loading` lists, or those along a curve.
   * A first, coarse curve tells where that begins and ends, and is what the others start from.
   */
  class CurveRequests
  {
  public:
    /** Finds them. @param first with which the first curve is computed
     * @throws UserError for a given torque beyond stall */
    CurveRequests(const Parameters &parameters, PointTable &table, const Discretisation &first);

    const std::vector<PointRequest> &all() const { return requests; }
    /** Those at which errors are measured: listed ones, and some along a curve. */
    const MeasuredPoints &measured() const { return measured_points; }
    /** Measures the errors of another point, too. */
    void measure(const PointRequest &request) { measured_points.add(request); }
    /** Whether the wave does not turn the rotor: within the target it stands still under a quarter
     * of the torque that friction can bear. This is then the last point of a curve. */
    bool rotor_sticks() const { return stalled.request.control == Control::torque; }
    /** The scales of errors. @param motor on the meshes in use */
    QuantityScales scales(const CondensedMotor &motor) const;

  private:
    /** Finds stall and, for a curve, no load; what the rotor is held by if it stands still. */
    void find_ends();
    /** The same at a given voltage: no load and, for a curve, stall. */
    void find_driven_ends();
    /** Loads a rotor that may stand still more and more, to see under which torques it does. */
    void find_held_torque();
    /** @throws UserError for a given torque beyond stall */
    void require_bearable_torques() const;
    /** Where the whole curve is computed: along its shape, or at rising torques if the rotor stands
     * still under all of them, or without load. */
    std::vector<PointRequest> points_of_curve();
    /** Speeds in even steps, from no load to stall: at a given voltage torques in between may be
     * larger than at stall. */
    std::vector<PointRequest> falling_speeds() const;
    /** Torques in even steps, from no load to the last point. */
    std::vector<PointRequest> rising_torques() const;
    /** Whether the rotor moves less than the target, relative to the wave's crests. */
    bool stands_still(const CurvePoint &point) const;
    /** Whether a curve is wanted whose points depend on its shape. */
    bool needs_shape() const;
    bool is_driven() const { return parameters.wave.drive == Drive::voltage; }
    bool is_listed() const { return !parameters.loading.values.empty(); }
    const CondensedMotor &motor() const { return table.motor(first.level, first.modes_level); }
    /** A point of the first curve. */
    CurvePoint find(const PointRequest &request) { return table.at(first, request); }

    const Parameters &parameters;
    PointTable &table;
    const Discretisation first;
    CurvePoint stalled;            ///< the loaded point if the rotor sticks
    double stall_torque      = 0.; ///< N m
    double largest_amplitude = 0.; ///< m, of the wave; that without load
    /** The first points of all: at rest if the rotor may stand still, then those that tell the
     * shape of the curve. */
    std::vector<CurvePoint> outline;
    std::vector<PointRequest> requests;
    MeasuredPoints measured_points;
  };
} // namespace ringmotor
