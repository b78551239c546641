// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/quantities/curve_search.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    constexpr unsigned int finest_level = 3, most_parts = 16;

    /** The level whose change to @p level tells the error of the meshes. */
    unsigned int compared_with(const unsigned int level)
    {
      return level == 0 ? 1 : level - 1;
    }

    std::string short_text(const double number)
    {
      std::ostringstream text;
      text.precision(3);
      text << number;
      return text.str();
    }
  } // namespace

  CurveSearch::CurveSearch(const Parameters &parameters, const double wave_error,
                           const Sources &sources)
      : parameters(parameters), wave_error(wave_error), sources(sources)
  {
  }

  void CurveSearch::find()
  {
    const Accuracy &accuracy = parameters.accuracy;
    const bool is_fixed      = accuracy.mode == AccuracyMode::fixed;
    if (!is_fixed && wave_error >= accuracy.contact_target)
      throw ComputationError(
          "the stator's wave is known to " + short_text(wave_error) +
          " (relative) only, but Accuracy/Contact target = " + short_text(accuracy.contact_target) +
          "; run the program stator with these parameters (and Accuracy/Mode = adaptive) first");
    reached = {is_fixed ? accuracy.interface_refinement : 1, parts_to_start_with()};
    estimate_errors(reached);
    while (!is_fixed && worst_error() > accuracy.contact_target)
      refine();
  }

  void CurveSearch::refine()
  {
    if (worst(time_errors(reached)) > worst(mesh_errors(reached)) && !is_marched(parameters) &&
        reached.n_parts < most_parts)
      reached.n_parts *= 2;
    else if (reached.level < finest_level)
    {
      ++reached.level;
      motors.erase(motors.begin(), motors.lower_bound(compared_with(reached.level)));
    }
    else
      throw ComputationError(
          "speeds and torques are known to " + short_text(worst_error()) +
          " (relative) on the finest interface mesh, but Accuracy/Contact target = " +
          short_text(parameters.accuracy.contact_target) + "; choose a larger one" +
          (is_marched(parameters) ? ", or a smaller Time/Time step" : ""));
    estimate_errors(reached);
  }

  unsigned int CurveSearch::parts_to_start_with() const
  {
    if (is_marched(parameters))
      return 1;
    const unsigned int n_teeth_that_differ =
        parameters.motor.n_teeth / std::gcd(parameters.motor.n_waves, parameters.motor.n_teeth);
    return parameters.accuracy.mode == AccuracyMode::fixed
               ? parameters.time.n_snapshots
               : std::max(parameters.time.n_snapshots,
                          (89 + n_teeth_that_differ) / n_teeth_that_differ);
  }

  const CondensedMotor &CurveSearch::motor_of(const unsigned int level)
  {
    auto &motor = motors[level];
    if (!motor)
    {
      const auto begin = std::chrono::steady_clock::now();
      motor            = std::make_unique<const CondensedMotor>(sources.motor(level));
      motor_seconds[level] =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    return *motor;
  }

  std::vector<CurvePoint> &CurveSearch::points_of(const CurveSetting &setting)
  {
    if (requests.empty())
      find_requests(setting);
    const auto known = curves.find(setting);
    if (known != curves.end())
      return known->second;
    return curves[setting] = sources.points(with_parts_of_a_step(parameters, setting.n_parts),
                                            motor_of(setting.level), setting, requests);
  }

  void CurveSearch::find_requests(const CurveSetting &setting)
  {
    stall_torque = sources
                       .points(with_parts_of_a_step(parameters, setting.n_parts),
                               motor_of(setting.level), setting, {{Control::speed, 0.}})
                       .front()
                       .result.torque;
    if (parameters.loading.control == Control::torque)
      for (const double torque : parameters.loading.values)
        if (torque >= stall_torque)
          throw UserError("Loading/Values = " + short_text(torque) +
                          " N m is beyond the stall of the motor, which is at " +
                          short_text(stall_torque) +
                          " N m; allowed: less than that, or Loading/Control = speed");
    requests = requested_points(parameters.loading, stall_torque);
  }

  std::vector<PointError> CurveSearch::mesh_errors(const CurveSetting &setting)
  {
    constexpr double margin = 1.25;
    const std::vector<CurvePoint> &other =
        points_of({compared_with(setting.level), setting.n_parts});
    return errors_by_change(other, points_of(setting), margin);
  }

  std::vector<PointError> CurveSearch::time_errors(const CurveSetting &setting)
  {
    constexpr double of_first_order = 2.;
    CurveSetting coarse{compared_with(setting.level), setting.n_parts}, half = coarse;
    half.n_parts *= 2;
    const std::vector<CurvePoint> &from = points_of(coarse);
    return errors_by_change(from, points_of(half), of_first_order);
  }

  void CurveSearch::estimate_errors(const CurveSetting &setting)
  {
    const std::vector<PointError> by_mesh = mesh_errors(setting), by_time = time_errors(setting);
    std::vector<CurvePoint> &points = points_of(setting);
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      const bool of_torque         = points[i].request.control == Control::torque;
      const OperatingPoint &result = points[i].result;
      const auto share             = [&](const double relative)
      {
        return PointError{of_torque ? relative * std::abs(result.speed) : 0.,
                          of_torque ? 0. : relative * std::abs(result.torque),
                          relative * result.friction_loss(), relative * points[i].rotor_power};
      };
      points[i].errors = {by_mesh[i], by_time[i], points[i].window, share(wave_error),
                          share(points[i].largest_violation)};
    }
  }

  double CurveSearch::worst_error() const
  {
    std::vector<PointError> errors;
    for (const CurvePoint &point : points())
      errors.push_back(point.errors.total());
    return worst(errors);
  }

  double CurveSearch::worst(const std::vector<PointError> &errors) const
  {
    double fastest = 0., largest = 0.;
    for (const CurvePoint &point : points())
      fastest = std::max(fastest, std::abs(point.result.speed));
    for (const PointError &error : errors)
      largest = std::max({largest, error.torque / stall_torque, // the motor may stand still
                          error.speed > 0. ? error.speed / fastest : 0.});
    return largest;
  }

  CurveSearch::StaticFrictionEffect CurveSearch::static_friction_effect()
  {
    const unsigned int middle = (requests.size() - 1) / 2;
    const bool of_torque      = requests[middle].control == Control::torque;
    Parameters plain          = with_parts_of_a_step(parameters, reached.n_parts);
    plain.friction.law        = FrictionLaw::coulomb;
    const CurvePoint dynamic  = sources.points(plain, motor(), reached, {requests[middle]}).front();
    CurveSetting coarse{compared_with(reached.level), reached.n_parts}, half = coarse;
    half.n_parts *= 2;
    const auto change = [&](const CurvePoint &from, const CurvePoint &to) {
      return of_torque ? to.result.speed - from.result.speed
                       : to.result.torque - from.result.torque;
    };
    return {points()[middle], change(points()[middle], dynamic),
            change(points_of(coarse)[middle], points_of(half)[middle]),
            change(points_of(coarse)[middle], points()[middle])};
  }

  double CurveSearch::point_seconds(const CurveSetting &setting)
  {
    double seconds = 0.;
    for (const CurvePoint &point : points_of(setting))
      seconds += point.seconds;
    return seconds;
  }

  CurveSearch::Rung CurveSearch::rung_of(const CurveSetting &setting)
  {
    reached = setting;
    estimate_errors(setting);
    const CurveSetting coarse{compared_with(setting.level), setting.n_parts},
        half{coarse.level, 2 * setting.n_parts};
    Rung rung;
    rung.setting       = setting;
    rung.n_nodes       = motor().nodes.size();
    rung.n_dofs        = motor().n_dofs;
    rung.n_steps       = std::lround(motor().period() / points().front().fields.time_step);
    rung.largest_error = worst_error();
    rung.seconds       = motor_seconds[setting.level] + point_seconds(setting);
    rung.seconds_with_error_bar =
        rung.seconds + motor_seconds[coarse.level] + point_seconds(coarse) + point_seconds(half);
    return rung;
  }

  std::vector<CurveSearch::Rung>
  CurveSearch::climb(const std::function<void(const Rung &)> &after_rung)
  {
    std::vector<Rung> rungs;
    const unsigned int first  = parts_to_start_with();
    const unsigned int finest = parameters.accuracy.mode == AccuracyMode::fixed
                                    ? std::max(1u, parameters.accuracy.interface_refinement)
                                    : finest_level;
    for (unsigned int level = 1; level <= finest; ++level)
    {
      motors.erase(motors.begin(), motors.lower_bound(compared_with(level)));
      // Half the step on the finest mesh would cost more than all other settings together.
      const unsigned int last = level < finest_level ? 2 * first : first;
      for (unsigned int n_parts = first; n_parts <= last; n_parts *= 2)
      {
        rungs.push_back(rung_of({level, n_parts}));
        after_rung(rungs.back());
      }
    }
    for (Rung &rung : rungs)
      rung.distance = worst(errors_by_change(points_of(rung.setting), points(), 1.));
    return rungs;
  }
} // namespace ringmotor
