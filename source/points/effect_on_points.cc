// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/relevant.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/effect_on_points.h>
#include <ringmotor/points/point_finder.h>
#include <ringmotor/points/point_quantities.h>
#include <ringmotor/structure/shared_work.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ringmotor
{
  namespace
  {
    /** The motor in its steady state with or without an effect, as it is compared. */
    Parameters compared(const Parameters &given, const Effect &effect, const EffectChoice choice)
    {
      Parameters parameters           = given;
      parameters.time.scheme          = TimeScheme::steady;
      parameters.effects[effect.name] = choice;
      // Friction that falls is an effect of its own. Without it, which hardly changes what another
      // effect does, there is a state, and it is found sooner.
      parameters.effects["Static friction excess"] = EffectChoice::off;
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

  EffectOnPoints EffectsOnPoints::of(const Effect &effect, const Parameters &parameters)
  {
    const std::vector<Motor *> both = condensed({compared(parameters, effect, EffectChoice::on),
                                                 compared(parameters, effect, EffectChoice::off)});
    Motor *const with = both[0], *const without = both[1];
    const PointRequest stall{Control::speed, 0.}, no_load{Control::torque, 0.};
    EffectOnPoints effect_on;
    effect_on.relative = std::numeric_limits<double>::infinity();
    const auto ends    = found({{with, stall, nullptr, false}, {with, no_load, nullptr, false}});
    if (ends[0].empty() || ends[1].empty())
      return effect_on;
    const auto before = found({{without, stall, nullptr, true}, {without, no_load, nullptr, true}});
    const CurvePoint &at_stall = before[0].front(), &at_no_load = before[1].front();
    const PointRequest half_load{Control::torque, 0.5 * at_stall.result.torque};
    const CurvePoint middle = found({{without, half_load, &at_no_load, true}}).front().front();
    const bool is_of_speed  = parameters.loading.control == Control::speed;
    const PointRequest same =
        is_of_speed ? PointRequest{Control::speed, middle.result.speed} : half_load;
    const auto after = found({{with, same, &ends[1].front(), false}}).front();
    if (after.empty())
      return effect_on;
    effect_on.change.raise(change(at_stall, ends[0].front()));
    effect_on.change.raise(change(at_no_load, ends[1].front()));
    effect_on.change.raise(change(middle, after.front()));
    effect_on.relative = std::max(effect_on.change["speed"] / at_no_load.result.speed,
                                  effect_on.change["torque"] / at_stall.result.torque);
    return effect_on;
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
        others.add_independent(of_points->second.change);
      }
  }

  PointError LeftOut::of(const CurvePoint &point) const
  {
    PointError error = relative * sizes_of(point);
    error.add_independent(others);
    error[prescribed(point.request).name] = 0.; // does not change
    return error;
  }
} // namespace ringmotor
