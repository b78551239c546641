// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/warp.h>
#include <ringmotor/pictures/motor_bodies.h>
#include <ringmotor/pictures/sector_field.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /**
   * `contact_000.vtu`, ... and `contact.pvd`, whose time is the torque in mN m: surfaces of teeth
   * and lip where they touch, for each operating point at its last time sample, for ParaView.
   * @p height (m) is that of the tooth tops. Fields pressure (Pa), friction (Pa), slip velocity
   * (m/s), status (0 open, 1 stick, 2 slip), gap (m), displacement of tooth and of rotor (m).
   * Collective: @p ranks write the files by turns.
   */
  void write_contact_surfaces(const std::string &folder, const CondensedMotor &motor,
                              const std::vector<CurvePoint> &points, const double height,
                              const MPI_Comm ranks);

  /** The motion of the whole stator. */
  struct StatorAtWave
  {
    SectorField field;
    double amplitude; ///< m, of the wave in it
    Warp warp;
  };

  /**
   * `rotor_000.vtu`, `teeth_000.vtu`, `base_000.vtu`, ... and `motor.pvd`: the whole bodies at the
   * same time samples, with their displacement (m) and, on the teeth, the same fields. Away from
   * contact points these are zero, and the gap is NaN, which ParaView shows in a separate colour.
   * Points with the same wave share the file of the base.
   * Collective: @p ranks write the files by turns.
   * @param motor in which the points were found; @param vibration of its rotor
   */
  void write_motor_bodies(const std::string &folder, const CondensedMotor &motor,
                          const MotorBodies &bodies, const RotorVibration &vibration,
                          const StatorAtWave &stator, const std::vector<CurvePoint> &points,
                          const double height, const MPI_Comm ranks);
} // namespace ringmotor
