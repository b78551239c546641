// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <iosfwd>
#include <string>

namespace ringmotor
{
  /** Prints the cross-sections of both bodies, as far as the parameters describe them, in JSON:
   * cells with their parts, edges with their names, slots, a shell; lengths in m. The rotor is
   * placed so that it touches the teeth. For the modes of a rotor the stator is left out. See
   * doc/files.md. */
  void print_sections(std::ostream &out, const Parameters &parameters);

  /** The same as a file. */
  void write_sections(const std::string &path, const Parameters &parameters);
} // namespace ringmotor
