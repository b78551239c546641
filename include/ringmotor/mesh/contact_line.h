// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/revolved_body.h>

#include <vector>

namespace ringmotor
{
  /** Between two radii, in m. */
  struct RadialRange
  {
    double inner = 0., outer = 0.;

    bool is_empty() const { return inner >= outer; }
    double width() const { return outer - inner; }
    /** m^2, of the ring between them */
    double area() const;
    /** What both have in common. */
    RadialRange common(const RadialRange &other) const;
  };

  /** From the innermost to the outermost of some places (r, z); empty without any. */
  RadialRange radii_around(const std::vector<dealii::Point<2>> &places);

  /** Where a body can touch the other one, in its section. */
  struct ContactLine
  {
    RadialRange radii;                ///< empty: nowhere
    double lowest = 0., highest = 0.; ///< m, in the body's own coordinates
  };

  /** The line from the innermost to the outermost of some places (r, z). */
  ContactLine contact_line_through(const std::vector<dealii::Point<2>> &places);

  /** The edges in contact of a stator, the tops of its teeth, or of a rotor, the lower face of its
   * lip or lining. */
  ContactLine contact_line(const RevolvedBody &body);

  /** Ranges in ascending order; those that continue each other are one. */
  std::vector<RadialRange> joined(std::vector<RadialRange> ranges);

  /** The radii of the lower faces of a stator that lie on the felt, see joined(). */
  std::vector<RadialRange> radii_on_felt(const RevolvedBody &stator);
} // namespace ringmotor
