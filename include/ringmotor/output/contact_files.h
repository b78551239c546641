// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/lip_amplification.h>
#include <ringmotor/points/point_finder.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** `torque_speed.csv`: one row for each operating point. */
  void write_torque_speed(const std::string &path, const std::vector<CurvePoint> &points);

  /** `history.csv`: forces and displacements against time of the contact points nearest to these
   * places; without any, of the nodes of tooth 0 that lie on its outermost line. In the steady
   * state teeth stand for times: one period in the order in which a tooth goes through it. */
  void write_history(const std::string &path, const CondensedMotor &motor,
                     const std::vector<CurvePoint> &points, const bool is_steady,
                     const std::vector<HistoryPoint> &places);

  /** `lip.csv`: by how much inertia amplifies the lip's compliance, against frequency, for the
   * first harmonics of a wave of an angular frequency (rad/s). */
  void write_lip(const std::string &path, const LipAmplification &lip,
                 const double angular_frequency);
} // namespace ringmotor
