// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/curve_point.h>

#include <map>
#include <string>
#include <vector>

namespace ringmotor
{
  /**
   * How far the last of several means over equal spans of time may be from their limit: the larger
   * one of the last two changes or, where changes shrink slowly, the change to come if they
   * continue to shrink at this rate. Infinite for fewer than three means.
   */
  double remaining_change(const std::vector<double> &means);

  /** The later three quarters of some values, which estimate their mean independently of what
   * happened at first. */
  struct LaterMean
  {
    double mean = 0.;
    /** With a confidence of 95 %, by Student's distribution of the means of the three quarters. */
    double error = 0.;
  };
  /** Its error is infinite for fewer than twelve values. */
  LaterMean later_mean(const std::vector<double> &values);

  /**
   * What successive spans of a marched motor, of whole periods of its solution, say of its
   * long-time mean. Without inertia most motors settle to a motion that repeats itself. With
   * inertia many wander: vibrations with little damping exchange power with the contact for ever,
   * and only a mean over many spans has a limit.
   */
  class SpanMeans
  {
  public:
    /** Adds the next span, without fields. @param repeats see MarchedSpan::repeats */
    void add(CurvePoint span, const bool repeats);

    /** The last span, and how far it may be from the limit. */
    const CurvePoint &last() const { return spans.back(); }
    PointError error_of_last() const;

    /** The mean over the later three quarters of the spans, and how far it may be from the
     * long-time mean. */
    CurvePoint later() const;
    PointError error_of_later() const;

    /** The values of one quantity in all spans, see PointQuantity. */
    const std::vector<double> &values(const std::string &quantity) const
    {
      return by_quantity.at(quantity);
    }

  private:
    std::vector<CurvePoint> spans;
    std::map<std::string, std::vector<double>> by_quantity;
    bool repeats = false;
  };
} // namespace ringmotor
