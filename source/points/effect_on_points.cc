// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/relevant.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/effect_on_points.h>
#include <ringmotor/points/point_finder.h>
#include <ringmotor/points/point_quantities.h>
#include <ringmotor/points/quantity_scales.h>
#include <ringmotor/structure/shared_work.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ringmotor
{
  namespace
  {
    /** The motor in its steady state with or without an effect, as it is compared. */
    Parameters compared(const Parameters &given, const Effect &effect, const EffectChoice choice)
    {
      Parameters parameters  = given;
      parameters.time.scheme = TimeScheme::steady;
      // Friction that falls is an effect of its own. Without it, which hardly changes what another
      // effect does, there is a state, and it is found sooner.
      parameters.effects["Static friction excess"] = EffectChoice::off;
      parameters.effects[effect.name]              = choice;
      // It shall be cheap, and the same whatever the steps.
      parameters.time.n_snapshots = effect.n_snapshots_to_measure();
      return parameters;
    }

    /** What points depend on; `auto` stands for `on`, see motor_model(). */
    std::string key_of(Parameters parameters)
    {
      for (const auto &effect : all_effects())
        if (effect->choice(parameters) == EffectChoice::automatic)
          parameters.effects[effect->name] = EffectChoice::on;
      return text_of(relevant_for_points(parameters));
    }
  } // namespace

  struct EffectsOnPoints::Motor
  {
    explicit Motor(const Parameters &parameters) : parameters(parameters) {}

    const Parameters parameters;
    CondensedMotor bodies;
    /** By request; empty if there is none. */
    std::map<std::string, std::vector<CurvePoint>> points;
  };

  /** A point to be found, from a known one or else from that of a similar motor, or from rest. */
  struct EffectsOnPoints::Wanted
  {
    Motor *of;
    PointRequest request;
    const CurvePoint *start;
    bool is_needed; ///< else there may be none
  };

  EffectsOnPoints::EffectsOnPoints(const StatorWave &wave, const MotorVibration &vibration,
                                   const MPI_Comm communicator)
      : wave(wave), vibration(vibration), communicator(communicator)
  {
  }

  EffectsOnPoints::~EffectsOnPoints() = default;

  std::vector<EffectsOnPoints::Motor *>
  EffectsOnPoints::condensed(const std::vector<Parameters> &all)
  {
    constexpr unsigned int modes_level = RotorVibration::rough_level;
    std::vector<Motor *> wanted, unknown;
    for (const Parameters &parameters : all)
    {
      std::unique_ptr<Motor> &motor = motors[key_of(parameters)];
      if (!motor)
      {
        motor = std::make_unique<Motor>(parameters);
        unknown.push_back(motor.get());
        vibration.prepare(motor_model(parameters), modes_level, ModeSets::own); // by all ranks
      }
      wanted.push_back(motor.get());
    }
    std::vector<CondensedMotor> bodies = shared_work(
        unknown,
        [&](const Motor *motor)
        {
          return condense_motor(motor->parameters, wave, ContactDiscretisation::level(0),
                                modes_level, &vibration, ModeSets::own);
        },
        communicator);
    for (std::size_t i = 0; i < unknown.size(); ++i)
      unknown[i]->bodies = std::move(bodies[i]);
    return wanted;
  }

  const CurvePoint *EffectsOnPoints::known_to_similar(const Wanted &wanted) const
  {
    const bool has_inertia = motor_model(wanted.of->parameters).has_inertia();
    for (const auto &[key, motor] : motors)
    {
      const auto known = motor->points.find(wanted.request.text());
      if (known != motor->points.end() && !known->second.empty() &&
          motor_model(motor->parameters).has_inertia() == has_inertia)
        return &known->second.front();
    }
    return nullptr;
  }

  std::vector<std::vector<CurvePoint>> EffectsOnPoints::found(const std::vector<Wanted> &all)
  {
    std::vector<Wanted> unknown;
    for (const Wanted &one : all)
    {
      const auto known = one.of->points.find(one.request.text());
      // A point that was not found before and is needed now is looked for again, to say why.
      if (known == one.of->points.end() || (one.is_needed && known->second.empty()))
        unknown.push_back(one);
    }
    // From points of earlier calls, so that the values do not depend on the number of ranks.
    for (Wanted &one : unknown)
      if (!one.start)
        one.start = known_to_similar(one);
    const auto find = [](const Wanted &one) -> std::vector<CurvePoint>
    {
      try
      {
        OperatingPointFinder finder(one.of->parameters, one.of->bodies);
        if (!one.is_needed) // an effect with which there is hardly a state is included
          finder.search_briefly();
        return {finder.find(one.request, one.start)};
      }
      catch (const ComputationError &)
      {
        if (one.is_needed)
          throw;
        return {};
      }
    };
    std::vector<std::vector<CurvePoint>> points = shared_work(unknown, find, communicator);
    for (std::size_t i = 0; i < unknown.size(); ++i)
      unknown[i].of->points[unknown[i].request.text()] = std::move(points[i]);
    std::vector<std::vector<CurvePoint>> result;
    for (const Wanted &one : all)
      result.push_back(one.of->points.at(one.request.text()));
    return result;
  }

  std::vector<CurvePoint> EffectsOnPoints::all_found(Motor &of,
                                                     const std::vector<PointRequest> &requests,
                                                     const CurvePoint *start, const bool are_needed)
  {
    std::vector<Wanted> wanted;
    for (const PointRequest &request : requests)
      wanted.push_back({&of, request, start, are_needed});
    std::vector<CurvePoint> points;
    for (const std::vector<CurvePoint> &point : found(wanted))
      points.insert(points.end(), point.begin(), point.end());
    return points.size() == requests.size() ? points : std::vector<CurvePoint>();
  }

  namespace
  {
    constexpr double no_load = 0., stall = 1.; // shares of the stall torque
    /** Between them: half of it, and about the largest torque that a curve prescribes. */
    constexpr double under_load[] = {0.5, 0.85};

    /** Changes of prescribed numbers, which are zero, give way to those at a neighbouring load. */
    void complete(std::map<double, PointError> &changes)
    {
      const double torque     = changes.at(stall)["torque"];
      changes[stall]["speed"] = std::prev(changes.end(), 2)->second["speed"];
      for (auto &[load, change] : changes)
        change["torque"] = std::max(change["torque"], torque);
    }

    /** At the same loads of a motor, or at its speeds there. */
    std::vector<PointRequest> requests_of(const std::vector<CurvePoint> &points,
                                          const Control control)
    {
      std::vector<PointRequest> requests;
      for (const CurvePoint &point : points)
        requests.push_back(
            {control, control == Control::speed ? point.result.speed : point.request.value});
      return requests;
    }
  } // namespace

  EffectOnPoints EffectsOnPoints::of(const Effect &effect, const Parameters &parameters)
  {
    const std::vector<Motor *> both = condensed({compared(parameters, effect, EffectChoice::on),
                                                 compared(parameters, effect, EffectChoice::off)});
    Motor &with = *both[0], &without = *both[1];
    const bool is_needed = !is_marched(parameters); // that one without the effect has a state
    const std::vector<PointRequest> ends{{Control::torque, 0.}, {Control::speed, 0.}};
    const std::vector<CurvePoint> ends_with = all_found(with, ends, nullptr, false);
    if (ends_with.empty())
      return {};
    const std::vector<CurvePoint> ends_without = all_found(without, ends, nullptr, is_needed);
    if (ends_without.empty())
      return {};
    EffectOnPoints effect_on;
    effect_on.stall_torque = ends_without[1].result.torque;
    std::vector<PointRequest> loaded;
    for (const double load : under_load)
      loaded.push_back({Control::torque, load * effect_on.stall_torque});
    const std::vector<CurvePoint> before = all_found(without, loaded, &ends_without[0], is_needed);
    if (before.empty())
      return {};
    const std::vector<CurvePoint> after =
        all_found(with, requests_of(before, parameters.loading.control), &ends_with[0], false);
    if (after.empty())
      return {};
    for (std::size_t i = 0; i < before.size(); ++i)
      effect_on.changes[under_load[i]] = change(before[i], after[i]);
    for (const auto &[load, i] : {std::pair(no_load, 0u), std::pair(stall, 1u)})
      effect_on.changes[load] = change(ends_without[i], ends_with[i]);
    effect_on.relate_to(
        scales_of(parameters, without.bodies, wave.amplitude, effect_on.stall_torque),
        ends_without[0].result.speed);
    complete(effect_on.changes);
    return effect_on;
  }

  void EffectOnPoints::relate_to(const QuantityScales &scales, const double fastest)
  {
    const PointError largest_change = largest();
    relative = std::max(largest_change["speed"] / scales.of("speed", fastest),
                        largest_change["torque"] / scales.of("torque", 0.));
  }

  PointError EffectOnPoints::at(const double torque) const
  {
    const double load =
        stall_torque == 0. ? no_load : std::clamp(torque / stall_torque, no_load, stall);
    const auto above  = changes.upper_bound(load);
    PointError larger = std::prev(above)->second;
    return above == changes.end() ? larger : larger.raise(above->second);
  }

  PointError EffectOnPoints::largest() const
  {
    PointError largest;
    for (const auto &[load, change] : changes)
      largest.raise(change);
    return largest;
  }

  LeftOut::LeftOut(const std::vector<EffectRow> &rows,
                   const std::map<std::string, EffectOnPoints> &measured)
  {
    for (const EffectRow &row : rows)
      if (row.is_left_out())
      {
        const auto of_points = measured.find(row.name);
        if (of_points == measured.end())
        {
          relative = std::hypot(relative, *row.indicator);
          continue;
        }
        others.push_back(of_points->second);
      }
  }

  PointError LeftOut::of(const CurvePoint &point) const
  {
    PointError error = relative * sizes_of(point);
    for (const EffectOnPoints &effect : others)
      error.add_independent(effect.at(point.result.torque));
    error[prescribed(point.request).name] = 0.; // does not change
    return error;
  }
} // namespace ringmotor
