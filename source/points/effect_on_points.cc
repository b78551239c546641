// SPDX-License-Identifier: LGPL-2.1-or-later
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
    /** The motor with the effect, and without it. */
    struct Compared
    {
      Parameters parameters;
      CondensedMotor motor;
      bool has_effect;
    };

    /** A point to be found, from rest or from a known one. */
    struct Wanted
    {
      const Compared &of;
      PointRequest request;
      const CurvePoint *start;
    };

    /** Points of several motors, shared by ranks. Without the effect there must be a state; with it
     * there may be none. */
    std::vector<std::vector<CurvePoint>> points_if_found(const std::vector<Wanted> &all,
                                                         const MPI_Comm ranks)
    {
      const auto found = [](const Wanted &one) -> std::vector<CurvePoint>
      {
        const auto &[of, request, start] = one;
        try
        {
          return {OperatingPointFinder(of.parameters, of.motor).find(request, start)};
        }
        catch (const ComputationError &)
        {
          if (of.has_effect)
            return {};
          throw;
        }
      };
      return shared_work(all, found, ranks);
    }
  } // namespace

  EffectOnPoints effect_on_points(const Parameters &all_parameters, const Effect &effect,
                                  const StatorWave &wave, const MotorVibration &vibration,
                                  const MPI_Comm communicator)
  {
    constexpr unsigned int modes_level = RotorVibration::rough_level;
    Compared with{all_parameters, CondensedMotor(), true},
        without{all_parameters, CondensedMotor(), false};
    for (Compared *each : {&with, &without})
    {
      Parameters &parameters          = each->parameters;
      parameters.time.scheme          = TimeScheme::steady;
      parameters.effects[effect.name] = each->has_effect ? EffectChoice::on : EffectChoice::off;
      // It shall be cheap, and the same whatever the steps.
      parameters.time.n_snapshots = effect.n_snapshots_to_measure();
    }
    vibration.prepare(motor_model(with.parameters), modes_level, ModeSets::own); // by all ranks
    std::vector<CondensedMotor> motors = shared_work(
        std::vector<const Compared *>{&with, &without},
        [&](const Compared *each)
        {
          return condense_motor(each->parameters, wave, ContactDiscretisation::level(0),
                                modes_level, &vibration, ModeSets::own);
        },
        communicator);
    with.motor    = std::move(motors[0]);
    without.motor = std::move(motors[1]);

    const PointRequest stall{Control::speed, 0.}, no_load{Control::torque, 0.};
    const auto ends = points_if_found({{with, stall, nullptr},
                                       {with, no_load, nullptr},
                                       {without, stall, nullptr},
                                       {without, no_load, nullptr}},
                                      communicator);
    EffectOnPoints effect_on;
    effect_on.relative = std::numeric_limits<double>::infinity();
    if (ends[0].empty() || ends[1].empty())
      return effect_on;
    const CurvePoint &at_stall = ends[2].front(), &at_no_load = ends[3].front();
    const PointRequest half_load{Control::torque, 0.5 * at_stall.result.torque};
    const auto before = points_if_found({{without, half_load, &at_no_load}}, communicator).front();
    const CurvePoint &middle = before.front();
    const bool is_of_speed   = all_parameters.loading.control == Control::speed;
    const PointRequest same =
        is_of_speed ? PointRequest{Control::speed, middle.result.speed} : half_load;
    const auto after = points_if_found({{with, same, &ends[1].front()}}, communicator).front();
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
