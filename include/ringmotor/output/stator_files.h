// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>
#include <ringmotor/pictures/surface_trace.h>
#include <ringmotor/wave/motor_circuits.h>

#include <string>
#include <vector>

namespace ringmotor
{
  constexpr unsigned int modes_format_version = 6;

  /** `frequencies.csv`: all modes with their error bars and their content. */
  void write_frequencies(const std::string &path, const std::vector<FoundMode> &modes);

  /** `ellipses.csv`: the elliptic motion of the named points in the travelling wave. */
  void write_ellipses(const std::string &path, const WaveResult &wave);

  /** `modes.h5`: everything `contact` and `losses` need of the wave and, unless null, of its
   * circuits, and the list of modes. See doc/files.md. */
  void write_modes_h5(const std::string &path, const Parameters &parameters,
                      const CyclicSector &sector, const std::vector<FoundMode> &modes,
                      const WaveResult *wave, const MotorCircuits *circuits = nullptr);
} // namespace ringmotor
