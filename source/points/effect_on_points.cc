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
    /** Points one after the other; none if a state is not found. */
    std::vector<CurvePoint> points_if_found(const Parameters &parameters,
                                            const CondensedMotor &motor,
                                            const std::vector<PointRequest> &requests)
    {
      OperatingPointFinder finder(parameters, motor);
      std::vector<CurvePoint> points;
      try
      {
        for (const PointRequest &request : requests)
          points.push_back(finder.find(request));
      }
      catch (const ComputationError &)
      {
        points.clear();
      }
      return points;
    }
  } // namespace

  EffectOnPoints effect_on_points(const Parameters &all_parameters, const Effect &effect,
                                  const StatorWave &wave, const MotorVibration &vibration,
                                  const MPI_Comm communicator)
  {
    constexpr unsigned int modes_level = RotorVibration::rough_level;
    Parameters with = all_parameters, without = all_parameters;
    with.time.scheme = without.time.scheme = TimeScheme::steady;
    // It shall be cheap, and the same whatever the steps.
    with.time.n_snapshots = without.time.n_snapshots = effect.n_snapshots_to_measure();
    with.effects[effect.name]                        = EffectChoice::on;
    without.effects[effect.name]                     = EffectChoice::off;
    const auto condensed                             = [&](const Parameters &parameters)
    {
      return condense_motor(parameters, wave, ContactDiscretisation::level(0), modes_level,
                            &vibration, ModeSets::own);
    };
    vibration.prepare(motor_model(with), modes_level, ModeSets::own); // by all ranks together
    const std::vector<CondensedMotor> motors = shared_work<CondensedMotor>(
        {[&] { return condensed(with); }, [&] { return condensed(without); }}, communicator);

    OperatingPointFinder finder(without, motors[1]);
    const CurvePoint stall   = finder.find({Control::speed, 0.}),
                     no_load = finder.find({Control::torque, 0.});
    CurvePoint middle        = finder.find({Control::torque, 0.5 * stall.result.torque});
    if (with.loading.control == Control::speed)
      middle.request = {Control::speed, middle.result.speed};

    const std::vector<std::vector<CurvePoint>> without_it{{no_load, middle}, {stall}};
    std::vector<std::function<std::vector<CurvePoint>()>> tasks;
    for (const std::vector<CurvePoint> &points : without_it)
      tasks.emplace_back(
          [&]
          {
            std::vector<PointRequest> requests;
            for (const CurvePoint &point : points)
              requests.push_back(point.request);
            return points_if_found(with, motors[0], requests);
          });
    const std::vector<std::vector<CurvePoint>> with_it = shared_work(tasks, communicator);
    EffectOnPoints effect_on;
    if (with_it[0].empty() || with_it[1].empty())
    {
      effect_on.relative = std::numeric_limits<double>::infinity();
      return effect_on;
    }
    for (std::size_t i = 0; i < with_it.size(); ++i)
      for (std::size_t j = 0; j < with_it[i].size(); ++j)
        effect_on.change.raise(change(without_it[i][j], with_it[i][j]));
    effect_on.relative = std::max(effect_on.change["speed"] / no_load.result.speed,
                                  effect_on.change["torque"] / stall.result.torque);
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
