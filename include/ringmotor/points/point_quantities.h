// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/torque_speed.h>
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
    double PointError::*error = nullptr; ///< also that of its parts; null if it is not known

    double value(const CurvePoint &point) const;
    /** Where a point stores it; null if it is derived from other numbers. */
    double *place(CurvePoint &point) const;
  };

  /**
   * All quantities that the program `contact` reports of an operating point. This is their only
   * list: each is a column of `torque_speed.csv`, an attribute of a point in `contact.h5`, and an
   * entry of `summary.json`; those that OperatingPoint stores are averaged and saved.
   */
  const std::vector<PointQuantity> &point_quantities();

  /** The quantities of a point with their errors; that of a prescribed one is zero. */
  std::vector<Quantity> quantities_of(const CurvePoint &point);

  /** The quantity to which an entry of PointError primarily belongs. */
  const PointQuantity &quantity_with(double PointError::*const error);

  /** The prescribed quantity; the point must have exactly this value. */
  const PointQuantity &prescribed(const PointRequest &request);
} // namespace ringmotor
