// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/results/quantity.h>

#include <string>

namespace ringmotor
{
  /** A number with this many digits after the decimal point. */
  std::string text(const double value, const int digits);

  /** A number as people read it, with its unit: `82.45 rpm`. */
  std::string text(const double value, const Unit &unit, const int digits);

  /** The same with its error bar: `82.45 +- 0.52 rpm`. */
  std::string text(const Estimate &estimate, const Unit &unit, const int digits);

  /** A number of two digits with its power of ten: `3.2e-04`. */
  std::string scientific(const double value);
} // namespace ringmotor
