// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace ringmotor
{
  /** A number with so many digits after the point. */
  std::string text(const double value, const int digits);

  /** A number of two digits with its power of ten: `3.2e-04`. */
  std::string scientific(const double value);
} // namespace ringmotor
