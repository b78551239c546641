// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/operating_point.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

namespace ringmotor
{
  namespace
  {
    /** The state at a contact point at the beginning of the step. */
    struct Before
    {
      PointVector force, free_motion;
      double gap;
    };

    /** Sets @p value to zero if it is mere rounding error of numbers of @p size. */
    void drop_rounding(double &value, const double size)
    {
      if (std::abs(value) < 1e-13 * size)
        value = 0.;
    }

    OperatingPoint evaluate(const OperatingState &state,
                            const std::function<Before(unsigned int)> &before)
    {
      const RingContact &contact      = *state.contact;
      const ContactSolution &solution = state.solution;
      OperatingPoint point;
      point.speed          = contact.speed(solution.state);
      point.torque         = contact.torque(solution.state);
      point.modal_power    = state.modal_power.taken;
      point.modal_damping  = state.modal_power.damped_by_factor;
      point.stator_damping = state.modal_power.lost_in_stator;
      // Converts sums over the points of all time samples to powers of the whole ring.
      const double per_second =
          contact.n_repeats() / (contact.n_time_samples() * contact.time_step());
      double pressed = 0., stuck = 0.;
      std::set<std::pair<unsigned int, unsigned int>> touching;
      for (unsigned int i = 0; i < contact.n_points(); ++i)
      {
        const PointVector &force = solution.state.force[i];
        const Before begin       = before(i);
        const PointVector mean   = 0.5 * (force + begin.force);
        if (mean == PointVector())
          continue;
        point.tangential_loss -= per_second * mean[1] * solution.motion[i][1];
        point.radial_loss -= per_second * mean[2] * solution.motion[i][2];
        point.output_work +=
            per_second * contact.time_step() * point.speed * contact.node(i).radius * mean[1];
        point.closing_work -= per_second * mean[0] * (solution.motion[i][0] - begin.gap);
        const double input = per_second * (mean * (contact.free_motion(i) - begin.free_motion));
        point.input_power += input;
        point.gross_power += std::abs(input);
        if (force[0] > 0.)
        {
          pressed += force[0];
          stuck += solution.status[i] == PointStatus::stick ? force[0] : 0.;
          touching.emplace(contact.sample(i), contact.tooth(i));
        }
      }
      const CondensedMotor &motor = contact.condensed_motor();
      point.amplitude             = contact.stator_wave().amplitude;
      point.teeth_in_contact      = static_cast<double>(touching.size()) * contact.n_repeats() /
                               (contact.n_time_samples() * motor.n_waves);
      point.stick_fraction = pressed > 0. ? stuck / pressed : 0.;
      drop_rounding(point.speed, motor.crest_speed(contact.stator_wave()));
      drop_rounding(point.torque, pressed * motor.nodes.front().radius);
      for (double OperatingPoint::*power :
           {&OperatingPoint::tangential_loss, &OperatingPoint::radial_loss,
            &OperatingPoint::output_work, &OperatingPoint::input_power})
        drop_rounding(point.*power, point.gross_power);
      return point;
    }
  } // namespace

  double OperatingPoint::missing_power() const
  {
    return input_power - output_work - friction_loss() - stored_power - modal_power;
  }

  double OperatingPoint::power_imbalance() const
  {
    return std::abs(missing_power()) / std::max({gross_power, friction_loss(), 1e-300});
  }

  double detuning(const OperatingState &state)
  {
    const RingContact &contact = *state.contact;
    double work                = 0.;
    for (unsigned int i = 0; i < contact.n_points(); ++i)
      work += state.solution.state.force[i] * contact.free_motion(i);
    work *= static_cast<double>(contact.n_repeats()) / contact.n_time_samples();
    const double energy = contact.stator_wave().energy;
    return energy > 0. ? work / (4. * energy) : 0.;
  }

  OperatingPoint evaluate(const OperatingState &state)
  {
    const RingContact &contact = *state.contact;
    OperatingPoint point =
        evaluate(state,
                 [&](const unsigned int i)
                 {
                   const unsigned int earlier = contact.earlier(i);
                   return Before{state.solution.state.force[earlier], contact.free_motion(earlier),
                                 state.solution.motion[earlier][0]};
                 });
    point.detuning              = ringmotor::detuning(state);
    point.second_stick_fraction = NodePass(state).second_stick_fraction(state.solution);
    return point;
  }

  OperatingPoint evaluate_step(const OperatingState &before, const OperatingState &state,
                               const NodePass &pass)
  {
    OperatingPoint point =
        evaluate(state,
                 [&](const unsigned int i)
                 {
                   return Before{before.solution.state.force[i], before.contact->free_motion(i),
                                 before.solution.motion[i][0]};
                 });
    point.stored_power = (state.contact->stored_energy(state.solution.state) -
                          before.contact->stored_energy(before.solution.state)) /
                         state.contact->time_step();
    point.second_stick_fraction = pass.second_stick_fraction(state.solution);
    return point;
  }

  OperatingPoint mean(const std::vector<OperatingPoint> &points, const std::vector<double> &lengths)
  {
    AssertDimension(points.size(), lengths.size());
    const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.);
    OperatingPoint mean;
    for (double OperatingPoint::*const quantity : OperatingPoint::members())
      for (std::size_t i = 0; i < points.size(); ++i)
        mean.*quantity += points[i].*quantity * lengths[i] / whole;
    return mean;
  }
} // namespace ringmotor
