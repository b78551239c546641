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
    return out.str();
  }

  std::string scientific(const double value)
  {
    std::ostringstream out;
    out << std::scientific << std::setprecision(1) << value;
    return out.str();
  }
} // namespace ringmotor
