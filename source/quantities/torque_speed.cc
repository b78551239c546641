// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/relevant.h>
#include <ringmotor/quantities/torque_speed.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Adds what happens at all points at the moments of a state. */
    void append_fields(ContactFields &fields, const OperatingState &state, const double first_time)
    {
      const RingContact &contact       = *state.contact;
      const ContactSolution &solution  = state.solution;
      const std::vector<PointVector> t = contact.tooth_motion(solution.state),
                                     r = contact.rotor_motion(solution.state);
      for (unsigned int moment = 0; moment < contact.n_times(); ++moment)
        fields.times.push_back(first_time + moment * contact.time_step());
      fields.n_teeth    = contact.n_teeth();
      fields.time_step  = contact.time_step();
      const auto append = [](auto &to, const auto &from)
      { to.insert(to.end(), from.begin(), from.end()); };
      append(fields.force, solution.state.force);
      append(fields.motion, solution.motion);
      append(fields.tooth, t);
      append(fields.rotor, r);
      const auto rigid       = solution.state.rigid.begin(); // a turn may follow
      const std::size_t size = contact.n_times() * contact.n_rigid_motions();
      fields.rigid.insert(fields.rigid.end(), rigid, rigid + size);
      fields.turn = solution.state.rigid.size() > size ? solution.state.rigid.back() : 0.;
      for (const PointStatus status : solution.status)
        fields.status.push_back(static_cast<unsigned char>(status));
    }

    /** The state that a point of the steady state was found in. */
    ContactState state_of(const CurvePoint &point)
    {
      ContactState state{point.fields.force, point.fields.rigid};
      if (point.request.control == Control::torque)
        state.rigid.push_back(point.fields.turn);
      return state;
    }

    void add_certificate(CurvePoint &point, const ContactSolution &solution)
    {
      point.largest_violation = std::max(point.largest_violation, solution.certificate.worst());
      point.n_iterations += solution.n_iterations;
      if (!solution.how.empty())
        point.remark = solution.how;
    }

    /** Adds what the rotor stores. The fields must be there. */
    void add_rotor_energy(CurvePoint &point, const CondensedMotor &motor,
                          const unsigned int warp_waves, const unsigned int first_moment)
    {
      point.rotor_energies =
          rotor_energies(point.fields, {motor.n_waves, motor.n_teeth, warp_waves}, first_moment);
      point.rotor_power = power_per_loss_factor(point.rotor_energies, motor.angular_frequency);
    }

    bool is_warped(const Parameters &parameters)
    {
      return parameters.initial_deformation.amplitude > 0. &&
             parameters.effects.initial_deformation != EffectChoice::off;
    }
  } // namespace

  std::vector<std::pair<std::string, PointError>> PointErrors::causes() const
  {
    return {{"meshes of bodies and interface", mesh},
            {"time step", time},
            {by_wave, wave},
            {"algebra", algebra}};
  }

  PointError PointErrors::total() const
  {
    PointError sum;
    for (const auto &cause : causes())
      sum += cause.second;
    return sum;
  }

  std::vector<double> warp_heights(const Parameters &parameters)
  {
    std::vector<double> heights;
    const InitialDeformation &deformation = parameters.initial_deformation;
    for (unsigned int tooth = 0; tooth < parameters.motor.n_teeth; ++tooth)
      heights.push_back(is_warped(parameters)
                            ? deformation.amplitude *
                                  std::cos(2. * numbers::PI * tooth * deformation.n_waves /
                                           parameters.motor.n_teeth)
                            : 0.);
    return heights;
  }

  bool is_marched(const Parameters &parameters)
  {
    if (parameters.time.scheme != TimeScheme::automatic)
      return parameters.time.scheme == TimeScheme::marching;
    return is_warped(parameters);
  }

  Parameters with_parts_of_a_step(const Parameters &parameters, const unsigned int n_parts)
  {
    Parameters divided = parameters;
    Time &time         = divided.time;
    if (!is_marched(parameters))
    {
      time.n_snapshots = n_parts;
      return divided;
    }
    time.time_step /= n_parts;
    time.n_steps *= n_parts;
    time.average_from_step = n_parts * (time.average_from_step - 1) + 1;
    time.average_to_step *= n_parts;
    return divided;
  }

  Friction effective_friction(const Parameters &parameters)
  {
    Friction friction = parameters.friction;
    if (parameters.effects.static_friction_excess == EffectChoice::off)
      friction.law = FrictionLaw::coulomb;
    return friction;
  }

  OperatingPointFinder::OperatingPointFinder(const Parameters &all_parameters,
                                             const CondensedMotor &motor, PointMemory *memory)
      : parameters(relevant_for_points(all_parameters)), motor(motor),
        friction(effective_friction(parameters)),
        steady(motor, friction, parameters.time.n_snapshots), memory(memory)
  {
  }

  RotorLoad OperatingPointFinder::load_of(const PointRequest &request) const
  {
    RotorLoad load{parameters.loading.preload, {}, request.value};
    if (request.control == Control::torque)
      load.torque = request.value;
    return load;
  }

  CurvePoint OperatingPointFinder::find(const PointRequest &request)
  {
    if (memory)
      if (std::optional<CurvePoint> known = memory->recall(request))
      {
        if (!is_marched(parameters))
          steady.go_on_from(load_of(request), state_of(*known));
        return *known;
      }
    const auto begin = std::chrono::steady_clock::now();
    CurvePoint point = is_marched(parameters) ? march(request) : find_steady(request);
    point.request    = request;
    point.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (memory)
      memory->keep(point);
    return point;
  }

  CurvePoint OperatingPointFinder::find_steady(const PointRequest &request)
  {
    const OperatingState state = steady.at(load_of(request));
    CurvePoint point;
    point.result = evaluate(state);
    add_certificate(point, state.solution);
    append_fields(point.fields, state, 0.);
    add_rotor_energy(point, motor, 0, 0);
    return point;
  }

  CurvePoint OperatingPointFinder::march(const PointRequest &request) const
  {
    const Time &time = parameters.time;
    MarchingDriver driver(motor, friction, warp_heights(parameters), parameters.loading.preload);
    CurvePoint point;
    OperatingState before;
    std::vector<OperatingPoint> averaged;
    for (unsigned int number = 1; number <= time.n_steps; ++number)
    {
      RotorLoad load = load_of(request);
      if (load.torque && number == 1) // the load comes with the second step
        load.torque = 0.;
      OperatingState state = driver.step(load, time.time_step);
      add_certificate(point, state.solution);
      append_fields(point.fields, state, driver.time());
      if (before.contact && number >= time.average_from_step && number <= time.average_to_step)
        averaged.push_back(evaluate_step(before, state));
      before = std::move(state);
    }
    point.result = mean(averaged);
    add_rotor_energy(point, motor,
                     is_warped(parameters) ? parameters.initial_deformation.n_waves : 0,
                     time.average_from_step - 1);
    return point;
  }

  std::vector<PointRequest> requested_points(const Loading &loading, const double stall_torque)
  {
    std::vector<PointRequest> requests;
    for (const double value : loading.values)
      requests.push_back({loading.control, value});
    if (!loading.values.empty())
      return requests;
    for (unsigned int i = 0; i + 1 < loading.n_curve_points; ++i)
      requests.push_back({Control::torque, stall_torque * i / (loading.n_curve_points - 1)});
    requests.push_back({Control::speed, 0.});
    return requests;
  }

  std::vector<CurvePoint> find_points(const Parameters &parameters, const CondensedMotor &motor,
                                      const std::vector<PointRequest> &requests,
                                      MPI_Comm communicator,
                                      const std::function<void(const CurvePoint &)> &after_point,
                                      PointMemory *memory)
  {
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator),
                       n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    OperatingPointFinder finder(parameters, motor, memory);
    std::vector<CurvePoint> mine;
    for (unsigned int i = rank; i < requests.size(); i += n_ranks)
    {
      mine.push_back(finder.find(requests[i]));
      after_point(mine.back());
    }
    const std::vector<std::vector<CurvePoint>> all = Utilities::MPI::all_gather(communicator, mine);
    std::vector<CurvePoint> points;
    for (unsigned int i = 0; i < requests.size(); ++i)
      points.push_back(all[i % n_ranks][i / n_ranks]);
    return points;
  }

  namespace
  {
    PointError change(const CurvePoint &from, const CurvePoint &to)
    {
      const bool of_torque    = to.request.control == Control::torque;
      const OperatingPoint &a = from.result, &b = to.result;
      return PointError{of_torque ? std::abs(a.speed - b.speed) : 0.,
                        of_torque ? 0. : std::abs(a.torque - b.torque),
                        std::abs(a.friction_loss() - b.friction_loss()),
                        std::abs(from.rotor_power - to.rotor_power)};
    }

    /** What a change of a point is measured by; zero for what is prescribed. */
    PointError measure(const CurvePoint &point)
    {
      const bool of_torque = point.request.control == Control::torque;
      return {of_torque ? 1. : 0., of_torque ? 0. : 1., point.result.friction_loss(),
              point.rotor_power};
    }

    /** The larger one of the two in the middle of an even number. */
    double median(std::vector<double> numbers)
    {
      const auto middle = numbers.begin() + numbers.size() / 2;
      std::nth_element(numbers.begin(), middle, numbers.end());
      return *middle;
    }
  } // namespace

  std::vector<PointError> errors_by_change(const std::vector<CurvePoint> &from,
                                           const std::vector<CurvePoint> &to, const double factor)
  {
    constexpr double flat_part = 0.95;
    double largest_torque      = 0.;
    for (const CurvePoint &point : to)
      largest_torque = std::max(largest_torque, std::abs(point.result.torque));
    std::vector<PointError> changes;
    for (unsigned int i = 0; i < to.size(); ++i)
      changes.push_back(change(from[i], to[i]));
    std::vector<PointError> errors = changes;
    for (double PointError::*part :
         {&PointError::speed, &PointError::torque, &PointError::loss, &PointError::rotor_power})
    {
      const auto tells = [&](const unsigned int i)
      {
        const bool is_flat = part == &PointError::speed && to.size() > 1 &&
                             std::abs(to[i].result.torque) >= flat_part * largest_torque;
        return measure(to[i]).*part > 0. && !is_flat;
      };
      std::vector<double> relative;
      for (unsigned int i = 0; i < to.size(); ++i)
        if (tells(i))
          relative.push_back(changes[i].*part / measure(to[i]).*part);
      const double typical = relative.empty() ? 0. : median(relative);
      for (unsigned int i = 0; i < to.size(); ++i)
        if (const double unit = measure(to[i]).*part; unit > 0.)
        {
          double &error = errors[i].*part;
          error         = std::max(error, typical * unit);
          for (const unsigned int neighbour : {i - 1, i + 1}) // before the first one: none
            if (neighbour < to.size() && tells(neighbour))
              error = std::max(error, changes[neighbour].*part);
          error *= factor;
        }
    }
    return errors;
  }
} // namespace ringmotor
