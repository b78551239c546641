// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/curve_point.h>
#include <ringmotor/results/quantity.h>

#include <string>
#include <variant>
#include <vector>

namespace ringmotor
{
  /** A quantity of operating points. */
  struct PointQuantity
  {
    std::string name;
    Unit unit;
    /** A number stored in points and in `contact.h5`, or one derived from such numbers. */
    std::variant<double OperatingPoint::*, double CurvePoint::*, double (OperatingPoint::*)() const>
        source;
    /** The quantity whose error bar is also that of this one, most often itself; empty: the error
     * is not known. */
    std::string error_of = {};

    double value(const CurvePoint &point) const;
    /** The value with its error bar by causes. */
    Estimate estimate(const CurvePoint &point) const;
    /** Where a point stores it; null if it is derived from other numbers. */
    double *place(CurvePoint &point) const;
    bool has_own_error() const { return error_of == name; }
  };

  /**
   * All quantities that the program `contact` reports of an operating point. This is their only
   * list: each is a column of `torque_speed.csv`, an attribute of a point in `contact.h5`, and an
   * entry of `summary.json`; those that OperatingPoint stores are averaged and saved; those with
   * errors of their own are compared between discretisations.
   */
  const std::vector<PointQuantity> &point_quantities();

  /** The one of a name, which must exist. */
  const PointQuantity &quantity_named(const std::string &name);

  /** The quantities of a point with their errors; that of a prescribed one is zero. */
  std::vector<Quantity> quantities_of(const CurvePoint &point);

  /** The prescribed quantity; the point must have exactly this value. */
  const PointQuantity &prescribed(const PointRequest &request);

  /** The values of all quantities that have errors of their own; zero for a prescribed one. */
  PointError values_of(const CurvePoint &point);

  /** The change of a point from one discretisation, or one wave, to another. Prescribed quantities
   * do not change. */
  PointError change(const CurvePoint &from, const CurvePoint &to);

  /** The absolute values: the error of a point that is wrong by all of itself. */
  PointError sizes_of(const CurvePoint &point);
} // namespace ringmotor
