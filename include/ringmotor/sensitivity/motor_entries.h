// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** An entry with a number of the motor that a designer may change. */
  struct MotorEntry
  {
    std::string path;  ///< `Section/Sub/Entry`
    double value;      ///< SI, not 0
    std::string units; ///< as declared: `m`, `Pa`, ...; `none` for a plain number
    /** What a small change is small against, in the same units: the value or, for a radius that
     * leaves little room to another one, the distance from it. */
    double scale;
    /** A radius of the rotor that is the same, and changes with it: where both bodies end at the
     * contact line, one of them alone would leave a step. Empty without one. */
    std::string together{};
  };

  /** All entries of the motor with a single number that is not whole and not 0, in the order of a
   * parameter file: not those of discretisation, accuracy and output, no lists and no words. Some
   * of them may affect nothing. Radii of the rotor that change together with others are left out.
   */
  std::vector<MotorEntry> motor_entries(const Parameters &parameters);

  /** The same motor with another value of an entry, and of that which changes together with it.
   * @throws UserError for a value that is not allowed */
  Parameters with_entry(const Parameters &parameters, const MotorEntry &entry, const double value);
} // namespace ringmotor
