// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/quantities/torque_speed.h>

#include <string>
#include <vector>

namespace ringmotor
{
  constexpr unsigned int contact_format_version = 1;

  /** `torque_speed.csv`: one row for each operating point. */
  void write_torque_speed(const std::string &path, const std::vector<CurvePoint> &points);

  /** `history.csv`: forces and displacements of the nodes of tooth 0 that lie on its outermost
   * line, against time. In the steady state teeth tell of times: one period in the order in which
   * it happens to tooth 0. */
  void write_history(const std::string &path, const CondensedMotor &motor,
                     const std::vector<CurvePoint> &points);

  /** `contact.h5`: all forces and displacements at the contact points. See doc/files.md. */
  void write_contact_h5(const std::string &path, const Parameters &parameters,
                        const CondensedMotor &motor, const std::vector<CurvePoint> &points);

  /** Surfaces of teeth and lip where they touch, at one moment, for ParaView: fields pressure (Pa),
   * friction (Pa), slip velocity (m/s), status (0 open, 1 stick, 2 slip), gap (m), displacement of
   * tooth and of rotor (m). */
  void write_contact_vtu(const std::string &path, const CondensedMotor &motor,
                         const CurvePoint &point, const unsigned int moment, const double height);
} // namespace ringmotor
