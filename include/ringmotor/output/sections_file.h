// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <string>

namespace ringmotor
{
  /** Writes the cross-sections of both bodies, as far as the parameters describe them, in JSON:
   * cells with their parts, edges with their names, slots, a shell; lengths in m. The rotor is
   * placed so that it touches the teeth. See doc/files.md. */
  void write_sections(const std::string &path, const Parameters &parameters);
} // namespace ringmotor
