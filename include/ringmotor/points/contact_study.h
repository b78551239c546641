// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/points/contact_settings.h>
#include <ringmotor/points/curve_point.h>
#include <ringmotor/points/quantity_scales.h>
#include <ringmotor/results/work_precision.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ringmotor
{
  /**
   * What accuracy costs the contact: the operating points of `Loading` or, for a curve, those at 0,
   * 25, 50, 75 and 90 % of the stall torque and the stall torque itself, for each of
   * contact_settings(). Every rank computes everything.
   */
  class ContactStudy
  {
  public:
    /** Finds the stall torque with the common setting. @p wave and @p vibration, of the rotor, must
     * outlive this object.
     * @throws UserError if a curve is requested of a rotor that sticks
     * @throws ComputationError */
    ContactStudy(const Parameters &parameters, const StatorWave &wave,
                 const MotorVibration &vibration);

    const std::vector<ContactSetting> &settings() const { return all; }

    /** All that the row of a setting depends on. */
    std::string key(const ContactSetting &setting) const;

    /** A row without results if the setting has no solution. */
    StudyRow compute(const ContactSetting &setting);

    /** @param rows of all settings @throws ComputationError if the best one has no results */
    WorkPrecision compare(const std::vector<StudyRow> &rows) const;

  private:
    /** A motor condensed for a setting, and what that took. */
    struct Condensed
    {
      CondensedMotor motor;
      double seconds; ///< including the modes of the rotor
    };
    /** The common motor and the last other one are remembered. */
    const Condensed &motor_of(const ContactSetting &setting);
    std::vector<CurvePoint> points_of(const ContactSetting &setting, const CondensedMotor &motor,
                                      const std::vector<PointRequest> &requests) const;
    void find_requests();
    /** The values of each of the held_quantities() at all points. */
    std::vector<std::vector<double>> results_of(const std::vector<CurvePoint> &points) const;

    const Parameters &parameters;
    const StatorWave &wave;
    const MotorVibration &vibration;
    const double period;                              ///< s, of the wave
    std::map<unsigned int, double> vibration_seconds; ///< by level
    std::map<std::string, std::unique_ptr<const Condensed>> motors;
    std::string common_motor; ///< its key among these
    CurvePoint stalled;
    QuantityScales scales;
    std::vector<PointRequest> requests;
    bool has_curve; ///< whose last request is stall, for the torque alone
    std::vector<ContactSetting> all;
  };
} // namespace ringmotor
