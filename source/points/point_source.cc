// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/points/point_finder.h>
#include <ringmotor/points/point_source.h>
#include <ringmotor/structure/shared_work.h>

#include <deal.II/base/timer.h>

#include <map>
#include <utility>

namespace ringmotor
{
  ComputedPoints::ComputedPoints(const Parameters &parameters, const StatorWave &wave,
                                 const MotorVibration &vibration, PointStore &store,
                                 Progress &progress, const MPI_Comm communicator)
      : parameters(parameters), wave(wave), vibration(vibration), store(store), progress(progress),
        communicator(communicator)
  {
  }

  std::vector<TimedMotor> ComputedPoints::motors(const std::vector<unsigned int> &levels,
                                                 const unsigned int modes_level)
  {
    const auto modes =
        motor_model(parameters).has_ring_modes() ? std::make_optional(modes_level) : std::nullopt;
    std::map<unsigned int, TimedMotor> known;
    std::vector<unsigned int> missing;
    for (const unsigned int level : levels)
      if (std::optional<TimedMotor> kept = store.recall_motor(level, modes))
        known.emplace(level, std::move(*kept));
      else
        missing.push_back(level);
    if (!missing.empty())
    {
      std::vector<TimedMotor> computed = condense(missing, modes_level);
      for (std::size_t i = 0; i < missing.size(); ++i)
      {
        store.keep_motor(missing[i], modes, computed[i].motor);
        known.emplace(missing[i], std::move(computed[i]));
      }
    }
    std::vector<TimedMotor> all;
    for (const unsigned int level : levels)
    {
      all.push_back(std::move(known.at(level)));
      progress.condensed(level, all.back().motor);
    }
    return all;
  }

  std::vector<TimedMotor> ComputedPoints::condense(const std::vector<unsigned int> &levels,
                                                   const unsigned int modes_level) const
  {
    if (motor_model(parameters).has_ring_modes()) // by all ranks together
    {
      progress.enter("vibrations of the bodies");
      vibration.prepare(motor_model(parameters), modes_level);
    }
    std::vector<TimedMotor> motors = shared_work(
        levels,
        [&](const unsigned int level)
        {
          progress.enter("condensation, interface mesh " + std::to_string(level));
          dealii::Timer timer;
          TimedMotor motor{condense_motor(parameters, wave, ContactDiscretisation::level(level),
                                          modes_level, &vibration)};
          motor.seconds = timer.wall_time();
          return motor;
        },
        communicator);
    progress.leave();
    return motors;
  }

  Parameters ComputedPoints::varied(const Discretisation &discretisation) const
  {
    Parameters varied = parameters;
    if (const Variation variation = discretisation.changes(); variation.change_parameters)
      variation.change_parameters(varied);
    return varied;
  }

  std::vector<std::vector<CurvePoint>> ComputedPoints::points(const std::vector<PointSet> &sets)
  {
    std::vector<PointJob> jobs;
    for (const auto &[discretisation, motor, requests, starts, anew] : sets)
    {
      PointJob job{varied(discretisation), motor, discretisation, wave.drive, requests, starts};
      if (const Variation variation = discretisation.changes(); variation.change_motor)
        variation.change_motor(job.motor, wave.relative_error);
      if (!anew)
        job.memory = store.points(job.parameters, discretisation);
      jobs.push_back(std::move(job));
    }
    std::vector<std::vector<CurvePoint>> points = find_points(jobs, communicator, &progress);
    progress.leave();
    return points;
  }

  void ComputedPoints::replace(const Discretisation &discretisation, const CurvePoint &point)
  {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      if (const auto memory = store.points(varied(discretisation), discretisation))
        memory->replace(point);
  }
} // namespace ringmotor
