// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/friction_law.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/parameters/accuracy_budget.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/marched_point.h>
#include <ringmotor/points/point_quantities.h>
#include <ringmotor/points/rotor_energy.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  double remaining_change(const std::vector<double> &means)
  {
    constexpr double slowest = 0.9; // ratio still distinguishable from no convergence
    const std::size_t n      = means.size();
    if (n < 3)
      return std::numeric_limits<double>::infinity();
    const double before = std::abs(means[n - 2] - means[n - 3]),
                 last   = std::abs(means[n - 1] - means[n - 2]),
                 ratio  = last < slowest * before ? last / before : slowest;
    return std::max({before, last, last * ratio / (1. - ratio)});
  }

  double wandering(const std::vector<double> &means)
  {
    constexpr std::size_t enough = 20;
    constexpr double margin      = 2.;
    if (means.size() < enough)
      return std::numeric_limits<double>::infinity();
    const auto [low, high] = std::minmax_element(means.begin() + means.size() / 2, means.end());
    return margin * (*high - *low);
  }

  MarchedRun::MarchedRun(const Parameters &parameters, const MotorInUse &motor,
                         const PointRequest &request, const unsigned int n_joined)
      : load(load_of(parameters.loading, request)), n_parts(parameters.time.n_snapshots),
        n_joined(n_joined),
        driver(motor, motor_model(parameters).friction, motor_model(parameters).warp, load.preload)
  {
  }

  MarchedSpan MarchedRun::advance(const unsigned int n_steps, const double length)
  {
    MarchedSpan span;
    std::vector<OperatingPoint> parts;
    std::vector<double> lengths; // of the parts
    for (unsigned int begin = 0; begin < n_steps; begin += n_joined)
    {
      const unsigned int together = std::min(n_joined, n_steps - begin);
      for (unsigned int part = 0; part < n_parts; ++part)
      {
        const double length_of_part = together * length / n_parts;
        if (std::optional<OperatingPoint> result = add_step(length_of_part, span.fields))
        {
          parts.push_back(*result);
          lengths.push_back(length_of_part);
        }
        if (span.fields.times.size() == 1)
          span.fields.reserve((n_steps + n_joined - 1) / n_joined * n_parts);
      }
    }
    span.mean = mean(parts, lengths);
    return span;
  }

  OperatingState MarchedRun::step(const RotorLoad &now, const double length)
  try
  {
    return driver.step(now, length);
  }
  catch (const ComputationError &error)
  {
    std::ostringstream text;
    text.precision(4);
    text << "no contact state found " << 1e6 * (driver.time() + length) << " us after the start "
         << text_of(load) << ": " << error.what();
    throw ComputationError(text.str());
  }

  std::optional<OperatingPoint> MarchedRun::add_step(const double length, ContactFields &fields)
  {
    const bool is_first = !last.contact;
    RotorLoad now       = load;
    if (is_first && now.torque)
      now.torque = 0.;
    OperatingState state = step(now, length);
    taken.add_certificate(state.solution);
    fields.append(fields_of(state, driver.time()));
    std::optional<OperatingPoint> result;
    if (is_first)
      pass.emplace(state.contact->n_points());
    else
      result = evaluate_step(last, state, *pass);
    pass->add(state.solution);
    last = std::move(state);
    return result;
  }

  namespace
  {
    /** Marches a motor until it has settled. */
    class Settling
    {
    public:
      Settling(const Parameters &parameters, const MotorInUse &motor, const PointRequest &request);

      /** Of a step, s: a period of the solution is a whole number of them. */
      double step_length() const;

      /** Continues marching a motor with inertia under decreasing damping, until those initial
       * transients that decay quickly have died out. */
      void calm(MarchedRun &run) const;
      /** Continues marching until the means have settled. @returns the point of the last span */
      CurvePoint settle(MarchedRun &run);
      /** How far the last span may be from their limit. */
      const PointError &remaining() const { return rest; }

      /** The operating point of a span. */
      CurvePoint point_of(MarchedSpan span) const;

    private:
      void add(const CurvePoint &point);
      /** Judges speed and torque relative to the largest ones of all operating points; a loss
       * relative to itself or, if larger, a thousandth of the friction loss at the speed of the
       * crests. */
      bool has_settled() const;
      [[noreturn]] void give_up() const;

      const Time time;
      const MotorInUse &motor;
      const PointRequest request;
      const RingPattern pattern;
      const unsigned int n_parts;                       ///< of a period of the wave, see Repetition
      const double tolerance;                           ///< relative
      double largest = 0.;                              ///< N m, if all friction points one way
      std::map<std::string, std::vector<double>> means; ///< of all spans, by quantity
      PointError rest;
    };

    Settling::Settling(const Parameters &parameters, const MotorInUse &motor,
                       const PointRequest &request)
        : time(parameters.time), motor(motor),
          request(request), pattern{motor.bodies.n_waves, motor.bodies.n_teeth,
                                    motor_model(parameters).warp.n_waves},
          n_parts(repetition_of(pattern).n_parts),
          tolerance(AccuracyBudget(parameters.accuracy).marched_means())
    {
      const Friction friction = motor_model(parameters).friction;
      const double mu         = law_of(friction).largest_coefficient(friction);
      for (const CondensedMotor::Node &node : motor.bodies.nodes)
        largest = std::max(largest, mu * parameters.loading.preload * node.radius);
    }

    double Settling::step_length() const
    {
      constexpr double rounding = 1e-3; // of a step given with a few digits
      const double period       = motor.wave.period() / n_parts;
      return period / std::ceil(period / time.time_step * (1. - rounding));
    }

    CurvePoint Settling::point_of(MarchedSpan span) const
    {
      CurvePoint point;
      point.request        = request;
      point.result         = span.mean;
      point.rotor_energies = rotor_energies(span.fields, pattern);
      point.rotor_power =
          power_per_loss_factor(point.rotor_energies, motor.wave.angular_frequency) +
          point.result.modal_damping;
      point.fields = std::move(span.fields);
      return point;
    }

    void Settling::calm(MarchedRun &run) const
    {
      // Amplitudes fall by a factor exp(pi eta) in a period.
      constexpr double decay = 2.;
      for (const double loss_factor : {0.3, 0.1, 0.03})
      {
        run.damp(loss_factor);
        const double n_periods = std::ceil(decay / (numbers::PI * loss_factor));
        run.advance(std::lround(n_periods * motor.wave.period() / step_length()), step_length());
      }
      run.damp(0.);
    }

    CurvePoint Settling::settle(MarchedRun &run)
    {
      // Short periods are combined to a quarter of the wave's: most teeth are in contact for less,
      // and lose their friction history when they separate.
      const unsigned int n_periods = (n_parts + 3) / 4;
      const auto n_steps           = static_cast<unsigned int>(
          std::lround(n_periods * motor.wave.period() / n_parts / step_length()));
      constexpr unsigned int most_spans = 60;
      for (unsigned int number = 0; number < most_spans; ++number)
      {
        CurvePoint point = point_of(run.advance(n_steps, step_length()));
        add(point);
        if (has_settled())
          return point;
      }
      give_up();
    }

    void Settling::add(const CurvePoint &point)
    {
      const PointError values = values_of(point);
      for (const PointQuantity &quantity : point_quantities())
        if (quantity.has_own_error())
        {
          std::vector<double> &all = means[quantity.name];
          all.push_back(values[quantity.name]);
          rest[quantity.name] = std::min(remaining_change(all), wandering(all));
        }
    }

    bool Settling::has_settled() const
    {
      // A sticking rotor has no losses that could settle; where friction falls with the velocity,
      // its oscillations with almost no loss may continue forever. The error bar includes them.
      constexpr std::size_t patience      = 20;
      constexpr double share              = 1e-3;
      const double little                 = share * largest * motor.bodies.crest_speed(motor.wave);
      const std::vector<double> &of_loss  = means.at("friction_loss"),
                                &of_rotor = means.at("rotor_power_per_loss_factor");
      return rest["speed"] <= tolerance * motor.bodies.crest_speed(motor.wave) &&
             rest["torque"] <= tolerance * largest &&
             rest["friction_loss"] <= tolerance * std::max(of_loss.back(), little) &&
             (rest["rotor_power_per_loss_factor"] <=
                  tolerance * std::max(of_rotor.back(), little) ||
              of_rotor.size() > patience);
    }

    void Settling::give_up() const
    {
      std::ostringstream text;
      text.precision(4);
      const bool of_torque = request.control == Control::torque;
      const auto range =
          [&](const std::string &name, const std::string &quantity, const std::string &unit)
      {
        const std::vector<double> &values = means.at(quantity);
        const auto [low, high] =
            std::minmax_element(values.begin() + values.size() / 2, values.end());
        text << name << " " << *low << " to " << *high << " " << unit;
      };
      text << "the motor does not settle at "
           << (of_torque ? 1e3 * request.value : request.value * 30. / numbers::PI)
           << (of_torque ? " mN m" : " rpm") << ": in the later half of "
           << means.at("speed").size() << " averaging spans of whole periods, the means have ";
      if (of_torque)
        range("speeds from", "speed", "rad/s");
      else
        range("torques from", "torque", "N m");
      range(" and friction losses from", "friction_loss", "W");
      text << "; choose a larger Accuracy/Contact target, a smaller Time/Time step"
           << (motor.bodies.rotor_mass > 0. ? ", or Effects/Rotor inertia = off" : "");
      throw ComputationError(text.str());
    }

    /** The operating point of the steps that `Time` specifies to average over. */
    CurvePoint find_by_window(const Time &time, MarchedRun &run, const Settling &settling)
    {
      ContactFields all;
      const auto advance = [&](const unsigned int n_steps)
      {
        MarchedSpan span = run.advance(n_steps, time.time_step);
        all.append(span.fields);
        return span;
      };
      advance(1); // still without the torque
      all.reserve(all.times.size() * *time.n_steps);
      advance(*time.average_from_step - 2);
      MarchedSpan window = advance(*time.average_to_step - *time.average_from_step + 1);
      advance(*time.n_steps - *time.average_to_step);
      CurvePoint point = settling.point_of(std::move(window));
      point.fields     = std::move(all);
      return point;
    }
  } // namespace

  CurvePoint find_marched(const Parameters &parameters, const MotorInUse &motor,
                          const PointRequest &request, const unsigned int n_joined)
  {
    MarchedRun run(parameters, motor, request, n_joined);
    Settling settling(parameters, motor, request);
    CurvePoint point;
    if (parameters.time.n_steps)
      point = find_by_window(parameters.time, run, settling);
    else
    {
      run.advance(1, settling.step_length());
      if (motor.bodies.rotor_mass > 0.)
        settling.calm(run);
      point                 = settling.settle(run);
      point.unsettled_means = settling.remaining();
    }
    point.largest_violation = run.effort().largest_violation;
    point.n_iterations      = run.effort().n_iterations;
    point.remark            = run.effort().remark;
    return point;
  }
} // namespace ringmotor
