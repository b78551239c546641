// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/curve_search.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  namespace
  {
    unsigned int first_modes_level(const Accuracy &accuracy)
    {
      return accuracy.mode == AccuracyMode::fixed ? accuracy.rotor_modes
                                                  : AccuracyBudget(accuracy).modes_level();
    }

    const Variation dynamic_friction_alone{"dynamic friction alone", [](Parameters &parameters) {
                                             parameters.friction.static_coefficient =
                                                 parameters.friction.dynamic_coefficient;
                                           }};
  } // namespace

  CurveSearch::CurveSearch(const Parameters &parameters, const StatorWave &wave,
                           PointSource &source, Progress &progress, const LeftOut &left_out)
      : parameters(parameters), budget(parameters.accuracy), wave_error(wave.relative_error),
        left_out(left_out), progress(progress),
        steps(parameters, 2. * dealii::numbers::PI / wave.angular_frequency),
        table(parameters, steps, source), scene{parameters,
                                                this->left_out,
                                                steps,
                                                table,
                                                0,
                                                first_modes_level(parameters.accuracy),
                                                motor_model(parameters).has_inertia()},
        finest_level(ContactDiscretisation::finest_level - (scene.has_inertia ? 1 : 0)),
        balance(steps.most_parts())
  {
  }

  void CurveSearch::find()
  {
    search();
    if (!is_marched(parameters))
      return;
    table.restore_fields(own_points(requests->all()));
    for (CurvePoint &result : results)
      result.fields = table.at(own(result.request), result.request).fields;
  }

  void CurveSearch::search()
  {
    const Accuracy &accuracy = parameters.accuracy;
    const bool is_fixed      = accuracy.mode == AccuracyMode::fixed;
    if (!is_fixed && wave_error >= accuracy.strictest_target())
      throw ComputationError(
          "the relative error of the stator's wave is " + short_text(wave_error) +
          ", but Accuracy/Contact target = " + short_text(accuracy.strictest_target()) +
          "; run the program stator with these parameters (and Accuracy/Mode = adaptive) first");
    scene.level = is_fixed ? accuracy.interface_refinement : 1;
    table.condense({scene.level, ErrorScene::compared_with(scene.level)}, scene.modes_level);
    requests = std::make_unique<CurveRequests>(parameters, table, for_first_curve());
    errors   = std::make_unique<const HeldErrors>(parameters, *requests, scene);
    for (const PointRequest &request : requests->all())
      n_parts[request] = steps.first_parts();
    if (is_fixed)
      return evaluate(requests->all());
    do
      refine_meshes();
    while (!suffices(requests->measured().all()) || !suffices(requests->all()));
  }

  bool CurveSearch::suffices(const std::vector<PointRequest> &these)
  {
    evaluate(these);
    // The power balance needs the shortest steps, which are worth their cost on the last mesh only.
    if (errors->worst_of(results) <= budget.whole())
      return powers_balance();
    refine();
    return false;
  }

  Discretisation CurveSearch::for_first_curve() const
  {
    // Given torques are compared with stall, which therefore has to be known well.
    const bool is_listed = !parameters.loading.values.empty();
    return is_marched(parameters) && !is_listed ? scene.for_variations() : scene.plain();
  }

  void CurveSearch::refine_meshes()
  {
    fill_starts();
    while (true)
    {
      double worst = 0.;
      for (const auto &cause : all_error_causes())
        if (cause->cure == Cure::meshes)
        {
          for (const Discretisation &needed : cause->needs(scene))
            table.fill({{needed, requests->measured().all()}}); // from the one before
          for (const PointRequest &request : requests->measured().all())
            worst = std::max(worst, errors->relative(cause->of(request, scene.plain(), scene)));
        }
      if (worst > budget.whole() && scene.level == finest_level)
        errors->refuse(worst, "on the finest interface mesh");
      if (worst <= budget.meshes() || scene.level == finest_level)
        return;
      take_finer_meshes();
    }
  }

  PointTable::Needs CurveSearch::own_points(const std::vector<PointRequest> &of) const
  {
    std::map<Discretisation, std::vector<PointRequest>> by_steps;
    for (const PointRequest &request : of)
      by_steps[own(request)].push_back(request);
    return {by_steps.begin(), by_steps.end()};
  }

  PointTable::Needs CurveSearch::needs_of(const std::vector<PointRequest> &these) const
  {
    const std::vector<PointRequest> &measured = requests->measured().all();
    const PointTable::Needs by_steps          = own_points(measured);
    PointTable::Needs needs                   = own_points(these);
    for (const auto &cause : all_error_causes())
    {
      for (const Discretisation &needed : cause->needs(scene))
        needs.emplace_back(needed, measured);
      for (const auto &[own_one, requests_of_it] : by_steps)
        for (const Discretisation &needed : cause->needs_beside(own_one, scene))
          needs.emplace_back(needed, requests_of_it);
    }
    return needs;
  }

  void CurveSearch::fill_starts()
  {
    std::vector<Discretisation> starts{scene.plain(), scene.for_variations()};
    if (is_marched(parameters)) // a coarse mesh and long steps first
      std::reverse(starts.begin(), starts.end());
    for (const Discretisation &start : starts)
      table.fill({{start, requests->measured().all()}});
  }

  void CurveSearch::evaluate(const std::vector<PointRequest> &these)
  {
    for (const PointRequest &request : these)
      n_parts.at(request) = std::max(n_parts.at(request), parts_nearby(request));
    fill_starts();
    table.fill(needs_of(these)); // together, to share them among ranks
    if (is_marched(parameters))
      table.drop_other_fields(own_points(requests->all()));
    results.clear();
    for (const PointRequest &request : these)
    {
      results.push_back(table.at(own(request), request));
      for (const auto &cause : all_error_causes())
        results.back().errors[cause->name] = error_of(*cause, request);
    }
  }

  unsigned int CurveSearch::parts_nearby(const PointRequest &request) const
  {
    unsigned int fewest = steps.most_parts();
    for (const PointRequest &measured : requests->measured().around(request))
      fewest = std::min(fewest, n_parts.at(measured));
    return fewest;
  }

  PointError CurveSearch::error_of(const ErrorCause &cause, const PointRequest &request)
  {
    if (!cause.compares(own(request), scene))
      return cause.of(request, own(request), scene);
    PointError error;
    for (const PointRequest &measured : requests->measured().around(request))
    {
      PointError there = cause.of(measured, own(measured), scene);
      if (cause.cure == Cure::steps)
      {
        // Errors of time integration are of first or second order: the safe side of both.
        const double length = own(measured).steps.number() / own(request).steps.number();
        there *= std::max(length, length * length);
      }
      error.raise(there);
    }
    return error.raise(cause.least_of(table.at(own(request), request), scene));
  }

  bool CurveSearch::powers_balance()
  {
    bool is_balanced = true;
    for (const CurvePoint &point : results)
    {
      const PointRequest &request = point.request;
      const unsigned int parts =

          balance.parts_for(point, scene.level, n_parts.at(request));
      if (parts == n_parts.at(request))
        continue;
      shorten_steps(request, parts);
      is_balanced = false;
    }
    return is_balanced;
  }

  std::map<Cure, double> CurveSearch::curable_errors(const CurvePoint &point) const
  {
    const std::map<Cure, bool> is_possible{
        {Cure::meshes, scene.level < finest_level},
        // Those of teeth are the same at all levels.
        {Cure::modes,
         scene.modes_level < RotorVibration::finest_level &&
             (motor().has_modes_of(ModePart::rotor) || motor().has_modes_of(ModePart::stator))},
        {Cure::steps, n_parts.at(point.request) < steps.most_parts()}};
    std::map<Cure, double> curable;
    for (const auto &cause : all_error_causes())
      if (cause->cure && is_possible.at(*cause->cure))
        curable[*cause->cure] += std::pow(errors->relative(point.errors.at(cause->name)), 2);
    return curable;
  }

  void CurveSearch::refine()
  {
    bool all_measured = true;
    for (const CurvePoint &point : results)
      if (!requests->measured().contain(point.request) &&
          errors->relative(point.error()) > budget.whole())
      {
        requests->measure(point.request);
        all_measured = false;
      }
    if (!all_measured)
      return;
    for (const auto &cause : all_error_causes())
      errors->require_bearable(*cause, results);
    const double target = std::pow(budget.whole(), 2); // squares add up
    std::set<Cure> needed;
    for (const CurvePoint &point : results)
    {
      double incurable = std::pow(errors->relative(point.error()), 2);
      if (incurable <= target)
        continue;
      const std::map<Cure, double> curable = curable_errors(point);
      for (const auto &[cure, square] : curable)
        incurable -= square;
      const std::set<Cure> cures = cheapest_cures(curable, incurable, target);
      if (cures.empty())
        errors->refuse(errors->worst_of(results),
                       "with the finest meshes, modes and steps that reduce it");
      if (cures.count(Cure::steps) > 0)
        shorten_steps(point.request, 2 * n_parts.at(point.request));
      needed.insert(cures.begin(), cures.end());
    }
    take(needed);
  }

  void CurveSearch::take(const std::set<Cure> &cures)
  {
    if (cures.count(Cure::meshes) > 0)
      take_finer_meshes();
    if (cures.count(Cure::modes) > 0)
    {
      ++scene.modes_level;
      table.drop_motors(0, scene.modes_level);
      table.condense({scene.level, ErrorScene::compared_with(scene.level)}, scene.modes_level);
    }
  }

  void CurveSearch::take_finer_meshes()
  {
    progress.before_refinement(scene.level + 1, table.motor_seconds(scene.level, scene.modes_level),
                               table.seconds(scene.plain()));
    ++scene.level;
    table.leave_first_curve();
    table.drop_motors(ErrorScene::compared_with(scene.level), scene.modes_level);
  }

  void CurveSearch::shorten_steps(const PointRequest &request, const unsigned int parts)
  {
    n_parts.at(request) = parts;
  }

  Parameters CurveSearch::frozen() const
  {
    unsigned int most_parts = 0;
    for (const auto &[request, parts] : n_parts)
      most_parts = std::max(most_parts, parts);
    Parameters frozen                    = with_parts_of_a_step(parameters, most_parts);
    frozen.accuracy.mode                 = AccuracyMode::fixed;
    frozen.accuracy.interface_refinement = scene.level;
    frozen.accuracy.rotor_modes          = scene.modes_level;
    return frozen;
  }

  CurveSearch::StaticFrictionEffect CurveSearch::static_friction_effect()
  {
    const PointRequest middle =
        requests->measured().around(requests->all()[(requests->all().size() - 1) / 2]).front();
    // Differences do not need steps so short that powers balance.
    const Discretisation plain = scene.for_variations();
    const CurvePoint &before   = table.at(plain, middle);
    const auto signed_change   = [&](const CurvePoint &from, const CurvePoint &to)
    {
      return middle.control == Control::torque ? to.result.speed - from.result.speed
                                               : to.result.torque - from.result.torque;
    };
    return {table.at(own(middle), middle), plain.steps.are_compared_with_longer(),
            signed_change(before, table.at(plain.with(dynamic_friction_alone), middle)),
            signed_change(before, table.at(plain.with(plain.steps.to_compare_with()), middle)),
            signed_change(table.at(scene.plain(ErrorScene::compared_with(scene.level)), middle),
                          table.at(scene.plain(), middle))};
  }
} // namespace ringmotor
