// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/quantities/curve_search.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <set>
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

    /** The same motor with a wave that moves its surface faster, but not higher. */
    CondensedMotor with_faster_wave(const CondensedMotor &motor, const double factor)
    {
      CondensedMotor faster = motor;
      for (CondensedMotor::Node &node : faster.nodes)
        for (const unsigned int c : {1u, 2u})
          node.free_motion[c] *= factor;
      return faster;
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
    reached_level = is_fixed ? accuracy.interface_refinement : 1;
    find_requests(parts_to_start_with());
    if (!is_fixed)
      balance_powers();
    evaluate();
    while (!is_fixed && worst_error() > accuracy.contact_target)
    {
      refine();
      balance_powers();
      evaluate();
    }
  }

  void CurveSearch::balance_powers()
  {
    // All at once, each from the one before; those with shorter steps start from them.
    std::vector<unsigned int> all(requests.size());
    std::iota(all.begin(), all.end(), 0u);
    points_of(plain_setting(reached_level), all);
    for (unsigned int i = 0; i < requests.size(); ++i)
      while (n_parts[i] < most_parts &&
             point_of({reached_level, n_parts[i]}, i).result.power_imbalance() >
                 OperatingPoint::largest_imbalance)
        n_parts[i] += (n_parts[i] + 2) / 3;
  }

  void CurveSearch::refine()
  {
    bool shortened = false, needs_mesh = false;
    for (unsigned int i = 0; i < requests.size(); ++i)
    {
      const PointErrors &errors = results[i].errors;
      if (relative(errors.total()) <= parameters.accuracy.contact_target)
        continue;
      if (relative(errors.time) > relative(errors.mesh) && n_parts[i] < most_parts)
      {
        n_parts[i] *= 2;
        shortened = true;
      }
      else
        needs_mesh = true;
    }
    if (!needs_mesh)
      return;
    if (reached_level < finest_level)
    {
      ++reached_level;
      motors.erase(motors.begin(), motors.lower_bound(compared_with(reached_level)));
    }
    else if (!shortened)
      throw ComputationError(
          "speeds and torques are known to " + short_text(worst_error()) +
          " (relative) on the finest interface mesh, but Accuracy/Contact target = " +
          short_text(parameters.accuracy.contact_target) + "; choose a larger one" +
          (is_marched(parameters) ? ", or a smaller Time/Time step" : ""));
  }

  unsigned int CurveSearch::parts_for(const unsigned int n_steps) const
  {
    if (is_marched(parameters))
      return 1;
    const unsigned int n_teeth_that_differ =
        parameters.motor.n_teeth / std::gcd(parameters.motor.n_waves, parameters.motor.n_teeth);
    return (n_steps - 1 + n_teeth_that_differ) / n_teeth_that_differ;
  }

  CurveSetting CurveSearch::plain_setting(const unsigned int level) const
  {
    return {level, parts_for(45)};
  }

  unsigned int CurveSearch::parts_to_start_with() const
  {
    if (parameters.accuracy.mode == AccuracyMode::fixed || is_marched(parameters))
      return parameters.time.n_snapshots;
    return std::max({plain_setting(0).n_parts + 1, parts_for(90), parameters.time.n_snapshots});
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

  std::vector<CurvePoint> CurveSearch::points_of(const CurveSetting &setting,
                                                 const std::vector<unsigned int> &wanted)
  {
    std::vector<unsigned int> missing;
    for (const unsigned int request : wanted)
      if (known[setting].count(request) == 0)
        missing.push_back(request);
    if (!missing.empty())
      compute(setting, missing);
    std::vector<CurvePoint> points;
    for (const unsigned int request : wanted)
      points.push_back(known[setting].at(request));
    return points;
  }

  void CurveSearch::compute(const CurveSetting &setting, const std::vector<unsigned int> &missing)
  {
    std::vector<PointRequest> asked;
    for (const unsigned int request : missing)
      asked.push_back(requests[request]);
    // Short steps and other waves are found from the state of one step per pitch.
    const CurveSetting plain = plain_setting(setting.level);
    std::vector<CurvePoint> starts;
    if (plain < setting && (plain.n_parts == 1 || plain.n_parts == setting.n_parts))
      starts = points_of(plain, missing);
    const Parameters divided = with_parts_of_a_step(parameters, setting.n_parts);
    std::vector<CurvePoint> points;
    if (setting.wave_factor == 1.)
      points = sources.points(divided, motor_of(setting.level), setting, asked, starts);
    else
      points =
          sources.points(divided, with_faster_wave(motor_of(setting.level), setting.wave_factor),
                         setting, asked, starts);
    for (unsigned int i = 0; i < missing.size(); ++i)
      known[setting][missing[i]] = points[i];
  }

  void CurveSearch::find_requests(const unsigned int n_parts_to_start_with)
  {
    requests                 = {{Control::speed, 0.}};
    const CurvePoint stalled = point_of(plain_setting(reached_level), 0);
    stall_torque             = stalled.result.torque;
    // Where all points stick at rest their forces are not determined; the rotor holds what friction
    // bears. Half of it is asked for, and refused if they slip.
    constexpr double all = 1. - 1e-9, asked_of_sticking = 0.5;
    sticks = stalled.result.stick_fraction > all;
    if (sticks)
      stall_torque = asked_of_sticking * parameters.friction.dynamic_coefficient *
                     parameters.loading.preload * motor_of(reached_level).nodes.front().radius;
    if (parameters.loading.control == Control::torque)
      for (const double torque : parameters.loading.values)
        if (torque >= stall_torque)
          throw UserError("Loading/Values = " + short_text(torque) +
                          " N m is beyond the stall of the motor, which is at " +
                          short_text(stall_torque) +
                          " N m; allowed: less than that, or Loading/Control = speed");
    requests = requested_points(parameters.loading, stall_torque);
    if (sticks && parameters.loading.values.empty())
      requests.back() = {Control::torque, stall_torque};
    known.clear();
    for (unsigned int i = 0; i < requests.size(); ++i)
      if (requests[i].control == Control::speed && requests[i].value == 0.)
        known[plain_setting(reached_level)][i] = stalled;
    n_parts.assign(requests.size(), n_parts_to_start_with);
  }

  PointErrors CurveSearch::errors_of(const unsigned int request)
  {
    constexpr double margin  = 2.;
    const CurveSetting plain = plain_setting(reached_level);
    const unsigned int parts = n_parts[request];
    const CurvePoint before  = point_of(plain, request),
                     coarse  = point_of(plain_setting(compared_with(reached_level)), request),
                     faster  = point_of({reached_level, plain.n_parts, 1. + wave_error}, request),
                     point   = point_of({reached_level, parts}, request);
    PointErrors errors;
    errors.mesh = change(coarse, before);
    errors.mesh *= margin;
    // Of first order, C / n with n steps per pitch: C follows from two of them.
    const unsigned int other = parts == plain.n_parts ? 2 * parts : plain.n_parts;
    errors.time              = change(point, point_of({reached_level, other}, request));
    errors.time *= static_cast<double>(other) / std::abs(static_cast<double>(other) - parts);
    errors.wave                  = change(before, faster);
    errors.window                = point.window;
    const OperatingPoint &result = point.result;
    const bool of_torque         = requests[request].control == Control::torque;
    errors.algebra               = {of_torque ? std::abs(result.speed) : 0.,
                      of_torque ? 0. : std::abs(result.torque), result.friction_loss(),
                      point.rotor_power};
    errors.algebra *= point.largest_violation;
    return errors;
  }

  void CurveSearch::evaluate()
  {
    // Together as far as possible: each point starts from the one before, and ranks share them.
    const CurveSetting plain = plain_setting(reached_level);
    std::vector<unsigned int> all(requests.size());
    std::iota(all.begin(), all.end(), 0u);
    for (const CurveSetting &setting :
         {plain, plain_setting(compared_with(reached_level)),
          CurveSetting{reached_level, plain.n_parts, 1. + wave_error}})
      points_of(setting, all);
    for (const unsigned int parts : std::set<unsigned int>(n_parts.begin(), n_parts.end()))
    {
      std::vector<unsigned int> these;
      for (const unsigned int i : all)
        if (n_parts[i] == parts)
          these.push_back(i);
      points_of({reached_level, parts == plain.n_parts ? 2 * parts : parts}, these);
    }
    results.clear();
    for (const unsigned int i : all)
    {
      results.push_back(point_of({reached_level, n_parts[i]}, i));
      results.back().errors = errors_of(i);
    }
  }

  double CurveSearch::worst_error() const
  {
    double worst = 0.;
    for (const CurvePoint &point : points())
      worst = std::max(worst, relative(point.errors.total()));
    return worst;
  }

  double CurveSearch::relative(const PointError &error) const
  {
    constexpr double slow = 0.01; // against the crests of the wave: as good as at rest
    double fastest        = 0.;
    for (const CondensedMotor::Node &node : motor().nodes)
      fastest = std::max(fastest, slow * motor().angular_frequency * std::abs(node.free_motion[1]) /
                                      node.radius);
    for (const CurvePoint &point : points())
      fastest = std::max(fastest, std::abs(point.result.speed));
    return std::max(error.torque / std::abs(stall_torque), // the motor may stand still
                    error.speed > 0. ? error.speed / fastest : 0.);
  }

  CurveSearch::StaticFrictionEffect CurveSearch::static_friction_effect()
  {
    const unsigned int middle = (requests.size() - 1) / 2;
    const bool of_torque      = requests[middle].control == Control::torque;
    Parameters without        = with_parts_of_a_step(parameters, n_parts[middle]);
    without.friction.law      = FrictionLaw::coulomb;
    const CurvePoint dynamic  = sources
                                   .points(without, motor(), {reached_level, n_parts[middle]},
                                           {requests[middle]}, {results[middle]})
                                   .front();
    const auto signed_change = [&](const CurvePoint &from, const CurvePoint &to) {
      return of_torque ? to.result.speed - from.result.speed
                       : to.result.torque - from.result.torque;
    };
    const CurveSetting plain = plain_setting(reached_level);
    const CurvePoint before  = point_of(plain, middle);
    return {results[middle], signed_change(results[middle], dynamic),
            signed_change(before, point_of({reached_level, 2 * plain.n_parts}, middle)),
            signed_change(point_of(plain_setting(compared_with(reached_level)), middle), before)};
  }

  double CurveSearch::point_seconds(const CurveSetting &setting)
  {
    double seconds = 0.;
    for (const auto &[request, point] : known[setting])
      seconds += point.seconds;
    return seconds;
  }

  CurveSearch::Rung CurveSearch::rung_of(const CurveSetting &setting)
  {
    reached_level = setting.level;
    if (requests.empty())
      find_requests(setting.n_parts);
    n_parts.assign(requests.size(), setting.n_parts);
    evaluate();
    const unsigned int coarse = compared_with(setting.level);
    Rung rung;
    rung.setting                = setting;
    rung.n_nodes                = motor().nodes.size();
    rung.n_dofs                 = motor().n_dofs;
    rung.n_steps                = std::lround(motor().period() / points().front().fields.time_step);
    rung.largest_error          = worst_error();
    rung.seconds                = motor_seconds[setting.level] + point_seconds(setting);
    const CurveSetting plain    = plain_setting(setting.level);
    rung.seconds_with_error_bar = motor_seconds[setting.level] + motor_seconds[coarse] +
                                  point_seconds(plain_setting(coarse)) + point_seconds(plain) +
                                  point_seconds({setting.level, plain.n_parts, 1. + wave_error});
    rung.seconds_with_error_bar += point_seconds(
        setting.n_parts == plain.n_parts ? CurveSetting{setting.level, 2 * plain.n_parts}
                                         : setting);
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
      for (unsigned int parts = first; parts <= last; parts *= 2)
      {
        rungs.push_back(rung_of({level, parts}));
        after_rung(rungs.back());
      }
    }
    for (Rung &rung : rungs)
    {
      rung.distance = 0.;
      for (const auto &[request, point] : known[rung.setting])
        rung.distance = std::max(rung.distance, relative(change(point, results[request])));
    }
    return rungs;
  }
} // namespace ringmotor
