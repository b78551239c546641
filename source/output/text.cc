// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/text.h>

#include <iomanip>
#include <sstream>

namespace ringmotor
{
  std::string text(const double value, const int digits)
  {
    std::ostringstream out;
    out << std::fixed << std::setprecision(digits) << value;
    const std::string text = out.str();
    // A number that is rounded to zero has no sign.
    return text.find_first_of("123456789n") == std::string::npos && text[0] == '-' ? text.substr(1)
                                                                                   : text;
  }

  std::string text(const double value, const Unit &unit, const int digits)
  {
    return text(value / unit.size, digits) + " " + unit.shown;
  }

  std::string text(const Estimate &estimate, const Unit &unit, const int digits)
  {
    return text(estimate.value / unit.size, digits) + " +- " + text(estimate.error(), unit, digits);
  }

  std::string scientific(const double value)
  {
    std::ostringstream out;
    out << std::scientific << std::setprecision(1) << value;
    return out.str();
  }
} // namespace ringmotor
