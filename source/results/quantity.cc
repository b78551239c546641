// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/results/quantity.h>

namespace ringmotor
{
  std::string name_with_unit(const std::string &name, const std::string &unit)
  {
    if (unit == "1")
      return name;
    std::string whole = name + "_";
    for (const char letter : unit)
      whole += letter == '/' ? "_per_" : letter == ' ' ? "" : std::string(1, letter);
    return whole;
  }
} // namespace ringmotor
