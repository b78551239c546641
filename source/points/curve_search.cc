// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/curve_search.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace ringmotor
{
  namespace
  {
    /** The same motor with a wave of larger tangential and radial, but not axial, motion, with
     * other modes, or with another scheme. */
    CondensedMotor changed(const CondensedMotor &motor, const CurveSetting &setting)
    {
      CondensedMotor other = motor;
      for (CondensedMotor::Node &node : other.nodes)
        for (const unsigned int c : {1u, 2u})
          node.free_motion[c] *= setting.wave_factor;
      if (setting.modes == ModesInUse::coarse)
        other.modes = other.coarse_modes;
      if (setting.modes == ModesInUse::of_other_harmonics)
        other.modes = other.modes_of_other_harmonics;
      if (setting.has_other_scheme)
        other.dynamics.scheme = other.dynamics.scheme.dissipating_otherwise();
      return other;
    }

    /** Targets from which on the modes of level 1 are likely to suffice. */
    constexpr double loose_target = 0.08;
  } // namespace

  CurveSearch::CurveSearch(const Parameters &parameters, const double wave_error,
                           const double period, const Sources &sources, const LeftOut &left_out)
      : parameters(parameters), wave_error(wave_error), steps(parameters, period), sources(sources),
        left_out(left_out), has_inertia(motor_model(parameters).has_inertia()),
        finest_level(ContactDiscretisation::finest_level - (has_inertia ? 1 : 0)),
        modes_level(
            parameters.accuracy.mode == AccuracyMode::fixed     ? parameters.accuracy.rotor_modes
            : parameters.accuracy.contact_target < loose_target ? RotorVibration::usual_level
                                                                : 1)
  {
  }

  void CurveSearch::find()
  {
    const Accuracy &accuracy = parameters.accuracy;
    const bool is_fixed      = accuracy.mode == AccuracyMode::fixed;
    if (!is_fixed && wave_error >= accuracy.strictest_target())
      throw ComputationError(
          "the relative error of the stator's wave is " + short_text(wave_error) +
          ", but Accuracy/Contact target = " + short_text(accuracy.strictest_target()) +
          "; run the program stator with these parameters (and Accuracy/Mode = adaptive) first");
    reached_level = is_fixed ? accuracy.interface_refinement : 1;
    condense({reached_level, compared_with(reached_level)});
    find_requests(steps.first_parts());
    while (true)
    {
      if (!is_fixed)
        refine_meshes();
      evaluate();
      if (is_fixed)
        return;
      // The power balance needs the shortest steps, which are worth their cost on the last mesh
      // only.
      if (worst_error() > accuracy.contact_target)
        refine();
      else if (powers_balance())
        return;
    }
  }

  void CurveSearch::refine_meshes()
  {
    // Short steps and other waves are worth their cost only on the final meshes, and take a share
    // of the target.
    constexpr double share = 0.9;
    const double target    = parameters.accuracy.contact_target;
    while (true)
    {
      find_on_both_meshes();
      double worst = 0.;
      for (const unsigned int i : all_requests())
        worst = std::max(worst, relative(mesh_error(i)));
      if (worst > target && reached_level == finest_level)
        refuse(worst);
      if (worst <= share * target || reached_level == finest_level)
        return;
      take_finer_meshes();
    }
  }

  void CurveSearch::take_finer_meshes()
  {
    sources.before_refinement(reached_level + 1, motor_seconds[reached_level],
                              point_seconds(steps.plain(reached_level)));
    ++reached_level;
    outline.clear();
    motors.erase(motors.begin(), motors.lower_bound(compared_with(reached_level)));
  }

  void CurveSearch::take_finer_modes()
  {
    ++modes_level;
    motors.clear();
    condense({reached_level, compared_with(reached_level)});
    if (!is_marched(parameters)) // where nothing starts from known points
      with_coarser_modes = std::move(known);
    known.clear();
  }

  void CurveSearch::require_accurate_drive() const
  {
    double worst = 0.;
    for (const CurvePoint &point : points())
      worst = std::max(worst, relative(point.errors.at(causes::drive)));
    if (worst > parameters.accuracy.contact_target)
      throw ComputationError(
          "at the given voltage the errors of the circuits of the phases alone change the results "
          "by " +
          short_text(worst) +
          ", Accuracy/Contact target = " + short_text(parameters.accuracy.contact_target) +
          (parameters.wave.frequency ? "; close to the resonance the frequency must be known well"
                                     : "") +
          ": run the program stator with a smaller Accuracy/Target first, or choose a larger "
          "Contact target");
  }

  void CurveSearch::shorten_step(const unsigned int request, const unsigned int parts)
  {
    if (is_marched(parameters)) // fields at many times, from which nothing starts
      known[{reached_level, n_parts[request]}][request].fields = {};
    n_parts[request] = parts;
  }

  std::vector<CurveSearch::Cure> CurveSearch::cures_of(const unsigned int request) const
  {
    const auto error = [&](const char *const cause)
    { return relative(results[request].errors.at(cause)); };
    std::vector<Cure> cures;
    const auto add = [&](const bool is_possible, const Cure &cure)
    {
      if (is_possible && cure.error > 0.)
        cures.push_back(cure);
    };
    // Those of teeth are the same at all levels.
    add(modes_level < RotorVibration::finest_level && motors.at(reached_level)->has_rotor_modes(),
        {Cure::Kind::modes, error(causes::modes), 0.5});
    // Where the state jumps with the frequency of the wave, it does so by one contact node and one
    // step.
    add(n_parts[request] < steps.most_parts(),
        {Cure::Kind::step,
         error(causes::time_step) + error(causes::scheme) + error(causes::algebra), 0.5});
    add(reached_level < finest_level, {Cure::Kind::mesh, error(causes::meshes), 0.35});
    std::sort(cures.begin(), cures.end(),
              [](const Cure &one, const Cure &other) { return one.error > other.error; });
    return cures;
  }

  void CurveSearch::refine()
  {
    require_accurate_drive();
    const double target = parameters.accuracy.contact_target;
    std::set<Cure::Kind> needed;
    for (const unsigned int i : all_requests())
    {
      double expected = relative(results[i].error());
      if (expected <= target)
        continue;
      const std::vector<Cure> cures = cures_of(i);
      double incurable              = expected;
      for (const Cure &cure : cures)
        incurable -= cure.error;
      if (cures.empty() || incurable > target)
        refuse(worst_error(), "with the finest meshes, modes and steps that reduce it");
      for (const Cure &cure : cures)
        if (expected > target)
        {
          expected -= (1. - cure.remains) * cure.error;
          needed.insert(cure.kind);
          if (cure.kind == Cure::Kind::step)
            shorten_step(i, 2 * n_parts[i]);
        }
    }
    if (needed.count(Cure::Kind::mesh) > 0)
      take_finer_meshes();
    if (needed.count(Cure::Kind::modes) > 0)
      take_finer_modes();
  }

  void CurveSearch::refuse(const double error, const std::string &where) const
  {
    throw ComputationError(
        "the relative error of " + parameters.accuracy.names_of_quantities() + " is still " +
        short_text(error) + " " + where +
        ", but Accuracy/Contact target = " + short_text(parameters.accuracy.contact_target) +
        "; choose a larger one" + (is_marched(parameters) ? ", or a smaller Time/Time step" : "") +
        (parameters.loading.control == Control::speed
             ? "; where the torque changes much with the speed, as near no load, prescribe torques"
             : ""));
  }

  void CurveSearch::condense(const std::vector<unsigned int> &levels)
  {
    std::vector<unsigned int> missing;
    for (const unsigned int level : levels)
      if (motors.count(level) == 0)
        missing.push_back(level);
    if (missing.empty())
      return;
    std::vector<TimedMotor> condensed = sources.motors(missing, modes_level);
    for (std::size_t i = 0; i < missing.size(); ++i)
    {
      motor_seconds[missing[i]] = condensed[i].seconds;
      motors[missing[i]] = std::make_unique<const CondensedMotor>(std::move(condensed[i].motor));
    }
  }

  const CondensedMotor &CurveSearch::motor_of(const unsigned int level)
  {
    condense({level});
    return *motors.at(level);
  }

  bool CurveSearch::needs_window(const CurveSetting &setting) const
  {
    return is_marched(parameters) && parameters.time.n_steps &&
           setting == steps.plain(reached_level);
  }

  void CurveSearch::find_points_of(CurveSetting setting, const std::vector<unsigned int> &wanted,
                                   const bool from_rest)
  {
    setting.tells_window = needs_window(setting);
    std::vector<unsigned int> missing;
    for (const unsigned int request : wanted)
    {
      const auto point = known[setting].find(request);
      if (point == known[setting].end() || (setting.tells_window && !point->second.tells_window))
        missing.push_back(request);
    }
    if (missing.empty())
      return;
    const std::vector<CurvePoint> starts = starts_for(setting, missing, from_rest);
    std::vector<PointRequest> asked;
    for (const unsigned int request : missing)
      asked.push_back(requests[request]);
    const CondensedMotor &motor = motor_of(setting.level);
    std::vector<CurvePoint> points =
        setting.has_changed_motor()
            ? sources.points(parameters, changed(motor, setting), setting, asked, starts)
            : sources.points(parameters, motor, setting, asked, starts);
    for (unsigned int i = 0; i < missing.size(); ++i)
      known[setting][missing[i]] = std::move(points[i]);
  }

  std::vector<unsigned int> CurveSearch::all_requests() const
  {
    std::vector<unsigned int> all(requests.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }

  void CurveSearch::find_on_both_meshes()
  {
    find_points_of(steps.plain(reached_level), all_requests());
    find_points_of(steps.plain(compared_with(reached_level)), all_requests());
  }

  void CurveSearch::find_with_own_steps()
  {
    for (const unsigned int parts : std::set<unsigned int>(n_parts.begin(), n_parts.end()))
    {
      std::vector<unsigned int> these;
      for (const unsigned int i : all_requests())
        if (n_parts[i] == parts)
          these.push_back(i);
      find_points_of({reached_level, parts}, these);
    }
  }

  void CurveSearch::evaluate()
  {
    // As many together as possible, to share them among the ranks.
    find_on_both_meshes();
    for (const CurveSetting &setting : changed_motors())
      find_points_of(setting, all_requests());
    find_with_own_steps();
    results.clear();
    for (const unsigned int i : all_requests())
    {
      results.push_back(point_of({reached_level, n_parts[i]}, i));
      results.back().errors = errors_of(i);
    }
  }
} // namespace ringmotor
