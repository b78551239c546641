// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/point_finder.h>

#include <string>
#include <vector>

namespace ringmotor
{
  constexpr unsigned int contact_format_version = 10;

  /** `contact.h5`: the operating points, with all forces and displacements at the contact points.
   * See doc/files.md. */
  void write_contact_h5(const std::string &path, const Parameters &parameters,
                        const StatorWave &wave, const CondensedMotor &motor,
                        const std::vector<CurvePoint> &points);

  /**
   * Reads the operating points, without their fields, from a file `contact.h5` that the program
   * `contact` has written with @p parameters on @p wave; loss factors and the felt may differ.
   * @throws UserError in one line if the file is missing, damaged, of another version or from other
   *         parameters, naming the first entry that differs, or another wave
   */
  std::vector<CurvePoint> read_contact_points(const std::string &path, const Parameters &parameters,
                                              const StatorWave &wave);
} // namespace ringmotor
