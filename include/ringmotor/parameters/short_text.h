// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sstream>
#include <string>

namespace ringmotor
{
  /** A number with three digits, for messages. */
  inline std::string short_text(const double number)
  {
    std::ostringstream text;
    text.precision(3);
    text << number;
    return text.str();
  }
} // namespace ringmotor
