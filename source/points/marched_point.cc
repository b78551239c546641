// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/friction_law.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/parameters/accuracy_budget.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/marched_point.h>
#include <ringmotor/points/rotor_energy.h>
#include <ringmotor/points/span_means.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    MarchingDriver driver_from(const MotorInUse &motor, const MotorModel &model,
                               const double preload, const MarchedState *start)
    {
      return start ? MarchingDriver(motor, model.friction, model.warp, *start)
                   : MarchingDriver(motor, model.friction, model.warp, preload);
    }
  } // namespace

  MarchedRun::MarchedRun(const Parameters &parameters, const MotorInUse &motor,
                         const PointRequest &request, const unsigned int n_joined,
                         const MarchedState *start)
      : begins_from_rest(!start), load(load_of(parameters.loading, request)),
        n_parts(parameters.time.n_snapshots), n_joined(n_joined),
        most_halvings(parameters.time.n_steps ? 0 : 2),
        driver(driver_from(motor, motor_model(parameters), load.preload, start))
  {
  }

  MarchedSpan MarchedRun::advance(const unsigned int n_steps, const double length)
  {
    MarchedSpan span;
    const double begin_of_span = driver.time();
    Evaluated evaluated;
    for (unsigned int begin = 0; begin < n_steps; begin += n_joined)
    {
      const unsigned int together = std::min(n_joined, n_steps - begin);
      for (unsigned int part = 0; part < n_parts; ++part)
      {
        const double length_of_part = together * length / n_parts;
        add_step(length_of_part, evaluated, most_halvings);
        span.fields.append(fields_of(last, driver.time()));
        span.fields.time_step = length_of_part; // even if it was halved
        if (span.fields.times.size() == 1)
          span.fields.reserve((n_steps + n_joined - 1) / n_joined * n_parts);
      }
    }
    span.mean    = mean(evaluated.results, evaluated.lengths);
    span.repeats = driver.repeats_from() <= begin_of_span;
    return span;
  }

  void MarchedRun::add_step(const double length, Evaluated &evaluated,
                            const unsigned int n_halvings)
  {
    OperatingState state;
    try
    {
      // Two halves are sooner found than what Newton's method does not find at once.
      state = step(length, n_halvings > 0 ? Fallback::none : Fallback::proximal_points);
    }
    catch (const ComputationError &)
    {
      if (n_halvings == 0)
        throw;
      for (unsigned int half = 0; half < 2; ++half)
        add_step(0.5 * length, evaluated, n_halvings - 1);
      taken.remark = "steps for which Newton's method did not converge were halved";
      return;
    }
    taken.add_certificate(state.solution);
    if (!last.contact)
      pass.emplace(state.contact->n_points());
    else
    {
      evaluated.results.push_back(evaluate_step(last, state, *pass));
      evaluated.lengths.push_back(length);
    }
    pass->add(state.solution);
    last = std::move(state);
  }

  OperatingState MarchedRun::step(const double length, const Fallback fallback)
  try
  {
    RotorLoad now = load;
    if (begins_from_rest && !last.contact && now.torque)
      now.torque = 0.;
    return driver.step(now, length, fallback);
  }
  catch (const ComputationError &error)
  {
    std::ostringstream text;
    text.precision(4);
    text << "no contact state found " << 1e6 * (driver.time() + length) << " us after the start "
         << text_of(load) << ": " << error.what();
    throw ComputationError(text.str());
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

      /** Continues marching until the mean is known. With inertia transients have to die out
       * first: under more damping than the motor's own, as little of it as turns out to be needed.
       * @throws ComputationError */
      CurvePoint settle(MarchedRun &run);

      /** The operating point of a span. */
      CurvePoint point_of(MarchedSpan span) const;

    private:
      /** Marches under a loss factor until quick transients have died out. */
      void calm(MarchedRun &run, const double loss_factor) const;
      /** Marches some spans until their mean is known, see SpanMeans. @returns the point, if it is
       */
      std::optional<CurvePoint> mean_of(MarchedRun &run, const unsigned int most_spans);
      /** Judges errors of speed and torque relative to the largest ones of all operating points;
       * those of the losses of friction and of the rotor's damping relative to the friction loss
       * or, if larger, to a thousandth of that at the speed of the crests. */
      bool is_small(const PointError &error, const CurvePoint &point, const double tolerance) const;
      [[noreturn]] void give_up() const;

      const Time time;
      const MotorInUse &motor;
      const PointRequest request;
      const RingPattern pattern;
      const unsigned int n_parts; ///< of a period of the wave, see Repetition
      const AccuracyBudget budget;
      const double loss_factor; ///< of the rotor
      const bool vibrates;
      double largest = 0.; ///< N m, if all friction points one way
      SpanMeans means;     ///< of the last attempt
    };

    Settling::Settling(const Parameters &parameters, const MotorInUse &motor,
                       const PointRequest &request)
        : time(parameters.time), motor(motor),
          request(request), pattern{motor.bodies.n_waves, motor.bodies.n_teeth,
                                    motor_model(parameters).warp.n_waves},
          n_parts(repetition_of(pattern).n_parts), budget(parameters.accuracy),
          loss_factor(parameters.materials.rotor_metal.loss_factor),
          vibrates(motor.bodies.rotor_mass > 0.)
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

    void Settling::calm(MarchedRun &run, const double loss_factor) const
    {
      // Amplitudes fall by a factor exp(pi eta) in a period.
      constexpr double decay = 2.;
      const double n_periods = std::ceil(decay / (numbers::PI * loss_factor));
      run.damp(loss_factor);
      run.advance(std::lround(n_periods * motor.wave.period() / step_length()), step_length());
      run.damp(0.);
    }

    CurvePoint Settling::settle(MarchedRun &run)
    {
      constexpr unsigned int few_spans = 24, most_spans = 80;
      std::optional<CurvePoint> point;
      if (!vibrates)
        point = mean_of(run, most_spans);
      else
      {
        if (run.begins_from_rest)
          calm(run, 0.3);
        else
          point = mean_of(run, few_spans);
        for (const auto &[loss_factor, n_spans] : {std::pair(0.1, few_spans), {0.03, most_spans}})
          if (!point)
          {
            calm(run, loss_factor);
            point = mean_of(run, n_spans);
          }
      }
      if (!point)
        give_up();
      point->end = run.state();
      return *point;
    }

    std::optional<CurvePoint> Settling::mean_of(MarchedRun &run, const unsigned int most_spans)
    {
      // Short periods are combined to a quarter of the wave's: most teeth are in contact for less,
      // and lose their friction history when they separate.
      const unsigned int n_periods = (n_parts + 3) / 4;
      const auto n_steps           = static_cast<unsigned int>(
          std::lround(n_periods * motor.wave.period() / n_parts / step_length()));
      means = {};
      for (unsigned int number = 0; number < most_spans; ++number)
      {
        MarchedSpan span     = run.advance(n_steps, step_length());
        const bool repeats   = span.repeats;
        CurvePoint point     = point_of(std::move(span));
        ContactFields fields = std::move(point.fields);
        means.add(std::move(point), repeats);
        const auto known = [&](CurvePoint result, const PointError &error)
        {
          result.unsettled_means = error;
          result.fields          = std::move(fields);
          return result;
        };
        if (const PointError error = means.error_of_last();
            (repeats || !vibrates) && is_small(error, means.last(), budget.marched_means()))
          return known(means.last(), error);
        CurvePoint later = means.later();
        if (const PointError error = means.error_of_later();
            is_small(error, later, budget.wandering_means()))
          return known(std::move(later), error);
      }
      return {};
    }

    bool Settling::is_small(const PointError &error, const CurvePoint &point,
                            const double tolerance) const
    {
      constexpr double share = 1e-3;
      const double crests    = motor.bodies.crest_speed(motor.wave),
                   loss      = std::max(point.result.friction_loss(), share * largest * crests);
      return error["speed"] <= tolerance * crests && error["torque"] <= tolerance * largest &&
             error["friction_loss"] <= tolerance * loss &&
             loss_factor * error["rotor_power_per_loss_factor"] <= tolerance * loss;
    }

    void Settling::give_up() const
    {
      std::ostringstream text;
      text.precision(4);
      const bool of_torque = request.control == Control::torque;
      const auto range =
          [&](const std::string &name, const std::string &quantity, const std::string &unit)
      {
        const std::vector<double> &values = means.values(quantity);
        const auto [low, high] =
            std::minmax_element(values.begin() + values.size() / 2, values.end());
        text << name << " " << *low << " to " << *high << " " << unit;
      };
      text << "the motor does not settle at "
           << (of_torque ? 1e3 * request.value : request.value * 30. / numbers::PI)
           << (of_torque ? " mN m" : " rpm") << ": in the later half of "
           << means.values("speed").size() << " averaging spans of whole periods, the means have ";
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
      point.end        = run.state(); // from which the motor goes on until it has settled
      return point;
    }
  } // namespace

  CurvePoint find_marched(const Parameters &parameters, const MotorInUse &motor,
                          const PointRequest &request, const unsigned int n_joined,
                          const CurvePoint *start)
  {
    const bool goes_on = !parameters.time.n_steps && start && start->end.is_known();
    MarchedRun run(parameters, motor, request, n_joined, goes_on ? &start->end : nullptr);
    Settling settling(parameters, motor, request);
    CurvePoint point;
    if (parameters.time.n_steps)
      point = find_by_window(parameters.time, run, settling);
    else
    {
      if (run.begins_from_rest)
        run.advance(1, settling.step_length());
      point = settling.settle(run);
    }
    point.largest_violation = run.effort().largest_violation;
    point.n_iterations      = run.effort().n_iterations;
    point.remark            = run.effort().remark;
    return point;
  }
} // namespace ringmotor
