// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/results/estimate.h>

#include <deal.II/base/numbers.h>

#include <string>

namespace ringmotor
{
  /** The SI unit of a number, and the unit in which it is shown. */
  struct Unit
  {
    const char *si, *shown; ///< as in `rad/s`; "1" for a pure number
    double size;            ///< of the shown unit, in SI
  };

  namespace units
  {
    inline constexpr Unit one{"1", "1", 1.}, percent{"1", "%", 1e-2};
    inline constexpr Unit hertz{"Hz", "Hz", 1.}, kilogram{"kg", "kg", 1.}, joule{"J", "J", 1.};
    inline constexpr Unit speed{"rad/s", "rpm", dealii::numbers::PI / 30.};
    inline constexpr Unit torque{"N m", "mN m", 1e-3};
    inline constexpr Unit power{"W", "mW", 1e-3};
    inline constexpr Unit voltage{"V", "V", 1.}, current{"A", "mA", 1e-3};
    inline constexpr Unit capacitance{"F", "nF", 1e-9}, motional_capacitance{"F", "pF", 1e-12},
        inductance{"H", "H", 1.}, resistance{"ohm", "ohm", 1.}, conductance{"S", "S", 1.},
        force_factor{"N/V", "N/V", 1.};
    inline constexpr Unit length{"m", "mm", 1e-3}, amplitude{"m", "um", 1e-6};
    inline constexpr Unit angle{"rad", "deg", dealii::numbers::PI / 180.};
    /** Of angles that are computed in degrees. */
    inline constexpr Unit degree{"deg", "deg", 1.};
  } // namespace units

  /** A result, with all that the outputs report of it. */
  struct Quantity
  {
    /** Without an error bar, because it is not known. */
    Quantity(const std::string &name, const Unit &unit, const double value)
        : name(name), unit(unit), estimate(value), has_error(false)
    {
    }
    Quantity(const std::string &name, const Unit &unit, const Estimate &estimate)
        : name(name), unit(unit), estimate(estimate), has_error(true)
    {
    }

    double value() const { return estimate.value; }

    std::string name; ///< the same in all outputs
    Unit unit;
    Estimate estimate; ///< in SI units
    bool has_error;
  };

  /** A name that carries a unit: `speed_rad_per_s`; that of a pure number carries none. */
  std::string name_with_unit(const std::string &name, const std::string &unit);
} // namespace ringmotor
