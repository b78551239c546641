// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/relevant.h>
#include <ringmotor/motor/warp.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/marched_point.h>
#include <ringmotor/points/point_finder.h>
#include <ringmotor/points/point_quantities.h>
#include <ringmotor/points/rotor_energy.h>
#include <ringmotor/structure/shared_work.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>

namespace ringmotor
{
  WaveLoad wave_load(const CurvePoint &point, const VoltageDrive &drive, const double frequency)
  {
    const OperatingPoint &result = point.result;
    return {result.amplitude, frequency, result.detuning,
            result.taken_from_wave(drive.rotor_loss_factor * point.rotor_power)};
  }

  OperatingPointFinder::OperatingPointFinder(Parameters all_parameters, const MotorInUse &motor,
                                             const Discretisation &discretisation,
                                             const std::optional<VoltageDrive> &drive,
                                             PointMemory *memory)
      : n_joined(discretisation.steps.n_joined), variation(discretisation.changes()),
        parameters(relevant_for_points(std::move(all_parameters))), model(motor_model(parameters)),
        motor(motor), drive(drive),
        steady(motor, model.friction, {parameters.time.n_snapshots, n_joined}),
        amplitude(motor.wave.amplitude), memory(memory)
  {
  }

  void OperatingPointFinder::begin(const PointRequest &request, const CurvePoint &start,
                                   const CurvePoint *start_before)
  {
    const RotorLoad load = load_of(parameters.loading, request);
    // With inertia the neighbour on the curve, changed as known states change from it to this
    // point, is closer than any of these states.
    const bool neighbour_is_nearer = model.has_inertia() && steady.has_state();
    if (start.fields.state.force.empty())
    {
      steady.start_from_rest();
      amplitude = motor.wave.amplitude;
      detuning  = 0.;
      return;
    }
    if (!neighbour_is_nearer)
    {
      begin_with_wave_of(start);
      steady.go_on_from(load, start.fields);
      return;
    }
    amplitude = start.result.amplitude;
    if (start_before)
    {
      detuning += start.result.detuning - start_before->result.detuning;
      steady.go_on_by_change(load, start_before->fields, start.fields);
    }
  }

  void OperatingPointFinder::begin_with_wave_of(const CurvePoint &start)
  {
    amplitude = start.result.amplitude;
    detuning  = start.result.detuning;
  }

  CurvePoint OperatingPointFinder::find(const PointRequest &request, const CurvePoint *start,
                                        const CurvePoint *start_before)
  {
    if (memory)
      if (std::optional<CurvePoint> known = memory->recall(request))
      {
        if (!model.is_marched)
        {
          steady.go_on_from(load_of(parameters.loading, request), known->fields);
          begin_with_wave_of(*known);
        }
        return *known;
      }
    const auto since      = std::chrono::steady_clock::now();
    const auto from_start = [&]
    {
      if (start)
        begin(request, *start, start_before);
      return find_steady(request);
    };
    // Impacts leave a motor with little damping several states close to each other.
    const auto anew = [&]
    {
      try
      {
        begin_with_wave_of(*start);
        return find_steady(request);
      }
      catch (const ComputationError &)
      {
        return from_start();
      }
    };
    CurvePoint point = model.is_marched ? find_marched(parameters, motor, request, n_joined, start)
                       : start && variation.starts_from_neighbours && !steady.has_state()
                           ? anew()
                           : from_start();
    point.request    = request;
    point.largest_share = point.fields.largest_share();
    point.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
    if (memory)
      memory->keep(point);
    return point;
  }

  namespace
  {
    /** What the search for an amplitude or a frequency leaves open. */
    PointError unsettled(const StableRoot<CurvePoint> &root)
    {
      // Logarithms and ratios: values change in proportion to them, at most quadratically.
      constexpr double of_values = 2.;
      return root.other ? root.share() * change(root.other->state, root.found.state)
                        : of_values * std::abs(root.found.excess) * sizes_of(root.found.state);
    }
  } // namespace

  bool OperatingPointFinder::is_negligible(const StableRoot<CurvePoint> &root) const
  {
    // Far below the smallest targets; what it is becomes part of the error bars.
    constexpr double negligible = 1e-4, little = 1e-2;
    const OperatingPoint &found = root.found.state.result;
    const double torque         = parameters.loading.preload * motor.bodies.nodes.front().radius,
                 speed =
                     motor.bodies.crest_speed(motor.wave) * found.amplitude / motor.wave.amplitude,
                 loss = std::max(found.friction_loss(), little * torque * speed);
    PointError rest   = unsettled(root);
    return rest["speed"] <= negligible * speed && rest["torque"] <= negligible * torque &&
           rest["friction_loss"] <= negligible * loss;
  }

  CurvePoint OperatingPointFinder::balance(const WaveUnknown &unknown, const double start,
                                           const TrialPoint &at) const
  {
    const StableRoot<CurvePoint> root = balanced<CurvePoint>(
        unknown, start, at,
        [&](const StableRoot<CurvePoint> &so_far) { return is_negligible(so_far); });
    CurvePoint point = root.found.state;
    point.unsettled += unsettled(root);
    return point;
  }

  CurvePoint OperatingPointFinder::find_driven(const PointRequest &request, const VoltageDrive &by)
  {
    const auto at = [&](const double logarithm)
    {
      CurvePoint point = find_at(request, std::exp(logarithm));
      const double own = by.natural_frequency.value * (1. + point.result.detuning);
      const double excess =
          by.excess(wave_load(point, by, by.frequency.value_or(own)), variation.has_drive_errors);
      return std::make_pair(excess, std::move(point));
    };
    CurvePoint point = balance(driven_amplitude, std::log(amplitude), at);
    amplitude        = point.result.amplitude;
    return point;
  }

  CurvePoint OperatingPointFinder::find_steady(const PointRequest &request)
  {
    return drive ? find_driven(request, *drive) : find_at(request, motor.wave.amplitude);
  }

  CurvePoint OperatingPointFinder::find_at(const PointRequest &request, const double of_wave)
  {
    const double natural = motor.wave.angular_frequency;
    if (!model.wave_feels_contact)
      return at_frequency(request, of_wave, natural);
    // The frequency at which the state found there has the detuning that this frequency requires.
    // With inertia the state depends on it, so that mere repetition converges slowly, beside a
    // resonance not at all.
    const auto at = [&](const double ratio)
    {
      CurvePoint point    = at_frequency(request, of_wave, ratio * natural);
      const double excess = ratio - 1. - point.result.detuning;
      return std::make_pair(excess, std::move(point));
    };
    CurvePoint point = balance(shifted_frequency, 1. + detuning, at);
    detuning         = point.result.detuning;
    return point;
  }

  CurvePoint OperatingPointFinder::at_frequency(const PointRequest &request, const double of_wave,
                                                const double at)
  {
    steady.set_wave(motor.wave.at(of_wave, at));
    const OperatingState found = steady.at(load_of(parameters.loading, request));
    const auto point_of        = [&](const OperatingState &state)
    {
      CurvePoint point;
      point.request = request;
      point.result  = evaluate(state);
      point.add_certificate(state.solution);
      point.fields = fields_of(state, 0.);
      point.rotor_energies =
          rotor_energies(point.fields, {motor.bodies.n_waves, motor.bodies.n_teeth, 0});
      point.rotor_power =
          power_per_loss_factor(point.rotor_energies, motor.wave.angular_frequency) +
          point.result.modal_damping;
      return point;
    };
    CurvePoint point = point_of(found);
    for (const OperatingState &other : found.others)
      point.unsettled.raise(change(point, point_of(other)));
    if (!found.others.empty())
      point.remark = "friction that falls with the slip leads from one state to another without "
                     "end; the error bars contain the range of " +
                     std::to_string(found.others.size() + 1) + " of them";
    return point;
  }

  namespace
  {
    /** Some neighbours of a job, whose points one rank finds. */
    struct Block
    {
      std::size_t job, first, last; ///< without the last one
    };

    /** Enough blocks of a job for all ranks to have work until the end, but not much shorter than
     * it takes for neighbours to be the better starts. */
    std::size_t n_blocks_of(const PointJob &job, const std::size_t n_jobs,
                            const std::size_t n_ranks)
    {
      constexpr std::size_t blocks_per_rank = 4, good_length = 3;
      if (n_ranks == 1)
        return 1;
      const auto ratio = [](const std::size_t a, const std::size_t b) { return (a + b - 1) / b; };
      const std::size_t n = job.requests.size(), one_per_rank = ratio(n_ranks, n_jobs);
      if (job.starts.empty()) // each block would begin from rest
        return std::min(n, one_per_rank);
      const std::size_t good =
          std::min(ratio(n, good_length), ratio(blocks_per_rank * n_ranks, n_jobs));
      return std::min(n, std::max(one_per_rank, good));
    }

    std::vector<Block> blocks_of(const std::vector<PointJob> &jobs, const std::size_t n_ranks)
    {
      std::vector<Block> blocks;
      for (std::size_t job = 0; job < jobs.size(); ++job)
      {
        const std::size_t n        = jobs[job].requests.size(),
                          n_blocks = n_blocks_of(jobs[job], jobs.size(), n_ranks);
        for (std::size_t block = 0; block < n_blocks; ++block)
          blocks.push_back({job, block * n / n_blocks, (block + 1) * n / n_blocks});
      }
      return blocks;
    }

    std::vector<CurvePoint> points_of(const PointJob &job, const Block &block,
                                      Progress *const progress)
    {
      const Discretisation &discretisation = job.discretisation;
      if (progress)
      {
        progress->enter("operating points, " + discretisation.text());
        progress->before_points(discretisation, job.motor.bodies, block.last - block.first);
      }
      OperatingPointFinder finder(
          with_parts_of_a_step(job.parameters, discretisation.steps.n_parts), job.motor,
          discretisation, job.drive, job.memory.get());
      std::vector<CurvePoint> points;
      for (std::size_t i = block.first; i < block.last; ++i)
      {
        const bool has_start = !job.starts.empty();
        points.push_back(finder.find(job.requests[i], has_start ? &job.starts[i] : nullptr,
                                     has_start && i > block.first ? &job.starts[i - 1] : nullptr));
        if (progress)
          progress->after_point(points.back());
      }
      return points;
    }
  } // namespace

  std::vector<std::vector<CurvePoint>> find_points(const std::vector<PointJob> &jobs,
                                                   const MPI_Comm communicator,
                                                   Progress *const progress)
  {
    const std::vector<Block> blocks =
        blocks_of(jobs, dealii::Utilities::MPI::n_mpi_processes(communicator));
    std::vector<std::vector<CurvePoint>> points(jobs.size()),
        of_blocks = shared_work(
            blocks, [&](const Block &block) { return points_of(jobs[block.job], block, progress); },
            communicator);
    for (std::size_t i = 0; i < blocks.size(); ++i)
      std::move(of_blocks[i].begin(), of_blocks[i].end(),
                std::back_inserter(points[blocks[i].job]));
    return points;
  }
} // namespace ringmotor
