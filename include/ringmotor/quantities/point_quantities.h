// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/quantities/quantity.h>
#include <ringmotor/quantities/torque_speed.h>

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
    /** A number that points keep and `contact.h5` gives back, or what follows from such numbers. */
    std::variant<double OperatingPoint::*, double CurvePoint::*, double (OperatingPoint::*)() const>
        source;
    double PointError::*error = nullptr; ///< also that of its parts; null if it is not known

    double value(const CurvePoint &point) const;
    /** Where a point keeps it; null for what follows from other numbers. */
    double *place(CurvePoint &point) const;
  };

  /**
   * All that the program `contact` tells of an operating point. This is the only list of them: each
   * is a column of `torque_speed.csv`, an attribute of a point in `contact.h5`, and an entry of
   * `summary.json`; what OperatingPoint keeps of it is averaged and stored.
   */
  const std::vector<PointQuantity> &point_quantities();

  /** The quantities of a point with their errors; that of what is prescribed is zero. */
  std::vector<Quantity> quantities_of(const CurvePoint &point);

  /** The quantity whose error bar an entry of PointError is in the first place. */
  const PointQuantity &quantity_with(double PointError::*const error);

  /** The quantity that is asked for; the point is to have just this value. */
  const PointQuantity &prescribed(const PointRequest &request);
} // namespace ringmotor
