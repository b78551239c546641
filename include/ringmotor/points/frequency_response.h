// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/point_finder.h>
#include <ringmotor/wave/frequency_error.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** A state of a motor at a given voltage and torque. */
  struct ResponsePoint
  {
    double amplitude;   ///< m, of the wave
    Estimate frequency; ///< Hz, of the drive
    Estimate speed;     ///< rad/s
    /** S, of the motion of a phase, see VoltageDrive::motional_admittance(). */
    Estimate conductance, susceptance;

    bool is_stable; ///< whether the wave keeps it; see FrequencyResponse
  };

  /**
   * All states of a motor at one voltage and torque while the frequency varies, from well below the
   * resonance over its peak to well above. Several of them may have the same frequency, as the
   * contact detunes a weak wave more than a strong one.
   *
   * They are found by amplitude: a wave of given amplitude has one state of contact, which tells
   * the two frequencies at which the voltage sustains it, see VoltageDrive::frequencies(). Along
   * the curve a state is stable where the frequency rises: elsewhere a slightly larger wave grows.
   */
  struct FrequencyResponse
  {
    double torque = 0.; ///< N m
    std::vector<ResponsePoint> points;
    std::string end; ///< why the curve does not reach smaller amplitudes; empty: it does

    /** Where a sweep of falling frequency loses the wave, and where one of rising frequency regains
     * it: the points before which or after which the frequency turns; null if it does not. */
    const ResponsePoint *loses() const;
    const ResponsePoint *regains() const;
  };

  /**
   * Computes the response at a torque (N m), with the contact in the state that it has at the
   * resonance with each amplitude, and with frequencies and speeds in proportion.
   *
   * Errors are twice the changes from @p coarse, the motor on other meshes, and from steps of half
   * the length, and those of the drive.
   * @param discretisation that of @p fine
   */
  FrequencyResponse frequency_response(const Parameters &parameters, const VoltageDrive &drive,
                                       const CondensedMotor &fine, const CondensedMotor &coarse,
                                       const Discretisation &discretisation, const double torque);
} // namespace ringmotor
