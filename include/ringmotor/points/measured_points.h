// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/curve_point.h>

#include <map>
#include <set>
#include <vector>

namespace ringmotor
{
  /**
   * At which points of a curve errors are measured, by computing these points in other ways as
   * well. Along a curve errors change slowly, and each of them vanishes somewhere by chance: those
   * of a point in between are the larger ones of the measured points on both sides. The ends are
   * always measured, also those of a part whose points all have a torque or all a speed given, as
   * other quantities have errors there.
   */
  class MeasuredPoints
  {
  public:
    /** Some that are an equal number of points apart, as far as this is possible, and by no more
     * than @p spacing; all, if it is one. @param curve in the order along it */
    explicit MeasuredPoints(const std::vector<PointRequest> &curve = {},
                            const unsigned int spacing             = 1);

    /** Measures another point of the curve, too. */
    void add(const PointRequest &request);

    const std::vector<PointRequest> &all() const { return measured; }
    bool contain(const PointRequest &request) const { return chosen.count(request) > 0; }
    /** The point itself if it is measured, else those on both sides. */
    const std::vector<PointRequest> &around(const PointRequest &request) const
    {
      return neighbours.at(request);
    }

  private:
    void find_neighbours();

    std::vector<PointRequest> curve;
    std::set<PointRequest> chosen;
    std::vector<PointRequest> measured; ///< these in the order of the curve
    std::map<PointRequest, std::vector<PointRequest>> neighbours;
  };
} // namespace ringmotor
