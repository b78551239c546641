// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/relevant.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/contact_study.h>
#include <ringmotor/points/point_finder.h>
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace ringmotor
{
  ContactStudy::ContactStudy(const Parameters &parameters, const StatorWave &wave,
                             const MotorVibration &vibration)
      : parameters(parameters), wave(wave), vibration(vibration),
        period(2. * dealii::numbers::PI / wave.angular_frequency),
        has_curve(parameters.loading.values.empty())
  {
    const ContactSetting common = common_setting(parameters, period);
    const CondensedMotor &motor = motor_of(common).motor;
    stalled                     = points_of(common, motor, {{Control::speed, 0.}}).front();
    scales = scales_of(parameters, motor, stalled.result.amplitude, stalled.result.torque);
    find_requests();
    all = contact_settings(parameters, {period, motor.constants.normal});
  }

  void ContactStudy::find_requests()
  {
    constexpr double sticking = 0.9;
    if (!has_curve)
    {
      requests = listed_points(parameters.loading);
      return;
    }
    if (stalled.result.stick_fraction > sticking)
      throw UserError("Loading/Values = curve has no stall torque that could be studied, because "
                      "nearly all contact nodes of the stalled rotor stick; allowed: torques or "
                      "speeds");
    for (const double share : {0., 0.25, 0.5, 0.75, 0.9})
      requests.push_back({Control::torque, share * stalled.result.torque});
    requests.push_back(stalled.request);
  }

  std::string ContactStudy::key(const ContactSetting &setting) const
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << "wave " << wave.identity() << "\n"
         << setting.knob << " " << setting.value << "\n"
         << setting.text();
    for (const PointRequest &request : requests)
      text << request.text() << "\n";
    return text.str();
  }

  const ContactStudy::Condensed &ContactStudy::motor_of(const ContactSetting &setting)
  {
    ContactSetting condensed = setting;
    condensed.parameters     = relevant_for_condensation(setting.parameters);
    condensed.n_steps        = 0.;
    const std::string key    = condensed.text();
    if (motors.empty())
      common_motor = key;
    if (const auto known = motors.find(key); known != motors.end())
      return *known->second;
    for (auto motor = motors.begin(); motor != motors.end();)
      motor = motor->first == common_motor ? std::next(motor) : motors.erase(motor);

    // The modes of the rotor are the same for all meshes of the same model.
    const bool shares_modes = !setting.is_other_model;
    double seconds          = 0.;
    if (motor_model(setting.parameters).has_ring_modes() && shares_modes)
    {
      const ProcessorTime time;
      vibration.prepare(motor_model(setting.parameters), setting.modes_level);
      seconds += vibration_seconds.emplace(setting.modes_level, time.seconds()).first->second;
    }
    MotorVibration modes_alone = vibration;
    modes_alone.bodies         = {}; // condensed bodies belong to the cost of each setting
    const ProcessorTime time;
    CondensedMotor motor =
        condense_motor(setting.parameters, wave, setting.discretisation, setting.modes_level,
                       shares_modes ? &modes_alone : nullptr);
    seconds += time.seconds();
    return *(motors[key] = std::make_unique<const Condensed>(Condensed{std::move(motor), seconds}));
  }

  std::vector<CurvePoint> ContactStudy::points_of(const ContactSetting &setting,
                                                  const CondensedMotor &motor,
                                                  const std::vector<PointRequest> &wanted) const
  {
    const StepChoice steps(setting.parameters, period);
    const Discretisation discretisation{0, setting.modes_level, steps.at_least(setting.n_steps)};
    return find_points({{setting.parameters, motor, discretisation, wave.drive, wanted}},
                       MPI_COMM_SELF)
        .front();
  }

  StudyRow ContactStudy::compute(const ContactSetting &setting)
  {
    const Condensed &condensed = motor_of(setting);
    StudyRow row;
    row.knob           = setting.knob;
    row.value          = setting.value;
    row.is_other_model = setting.is_other_model;
    row.counts         = {{"degree", setting.discretisation.degree},
                          {"nodes_per_tooth", static_cast<unsigned int>(condensed.motor.nodes.size())},
                          {"dofs", condensed.motor.n_dofs},
                          {"steps_per_period", static_cast<unsigned int>(std::lround(setting.n_steps))}};
    const ProcessorTime time;
    try
    {
      row.results = results_of(points_of(setting, condensed.motor, requests));
    }
    catch (const ComputationError &)
    {
      // Too coarse or too stiff to be solved: that is a result, too.
    }
    row.seconds = condensed.seconds + time.seconds();
    return row;
  }

  std::vector<std::vector<double>>
  ContactStudy::results_of(const std::vector<CurvePoint> &points) const
  {
    const std::vector<std::string> &studied = held_quantities();
    std::vector<std::vector<double>> results(studied.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const bool torque_alone = has_curve && i + 1 == points.size();
      for (std::size_t quantity = 0; quantity < studied.size(); ++quantity)
      {
        const bool is_torque     = studied[quantity] == "torque";
        const bool is_prescribed = studied[quantity] == prescribed(points[i].request).name;
        if (!is_prescribed && (is_torque || !torque_alone))
          results[quantity].push_back(quantity_named(studied[quantity]).value(points[i]));
      }
    }
    return results;
  }

  WorkPrecision ContactStudy::compare(const std::vector<StudyRow> &rows) const
  {
    const std::vector<std::vector<double>> &best = rows.back().results;
    if (best.empty())
      throw ComputationError("the best setting of the study, the finest interface mesh with short "
                             "steps, has no solution with which others could be compared; choose "
                             "Accuracy/Mode = fixed with a smaller Accuracy/Interface refinement");
    std::vector<WorkPrecision::Measure> measures;
    for (std::size_t i = 0; i < best.size(); ++i)
    {
      double largest = 0.;
      for (const double value : best[i])
        largest = std::max(largest, std::abs(value));
      const std::string &name = held_quantities()[i];
      measures.push_back({name, scales.of(name, largest)});
    }
    return {rows, measures, static_cast<unsigned int>(rows.size() - 1)};
  }
} // namespace ringmotor
