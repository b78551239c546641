// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>

namespace ringmotor
{
  /**
   * A number with its error bar, in the same unit, by causes. Errors of the same cause add up,
   * whatever their signs may be, and pass through sums, products and quotients in first order.
   * Causes are independent of each other: their squares add up.
   */
  class Estimate
  {
  public:
    using Errors = std::map<std::string, double>; ///< absolute, by cause

    /** An exact number. */
    Estimate(const double value = 0.) : value(value) {}
    Estimate(const double value, const Errors &errors) : value(value), errors(errors) {}
    /** With an error of a single cause. */
    Estimate(const double value, const double error, const std::string &cause)
        : value(value), errors{{cause, error}}
    {
    }

    /** The whole error bar: the root of the sum of squares of all causes. */
    double error() const;
    /** The same relative to the value; 0 for the number 0. */
    double relative_error() const;
    /** 1 with the relative errors: a factor that passes on these alone. */
    Estimate relative() const;
    /** 0 with the errors: a term that passes on these alone. */
    Estimate deviation() const { return {0., errors}; }

    Estimate &operator+=(const Estimate &other);

    double value;
    Errors errors;
  };

  Estimate operator+(Estimate one, const Estimate &other);
  Estimate operator-(const Estimate &one, const Estimate &other);
  Estimate operator*(const Estimate &one, const Estimate &other);
  Estimate operator/(const Estimate &one, const Estimate &other);
} // namespace ringmotor
