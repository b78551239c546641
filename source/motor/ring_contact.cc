// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/ring_contact.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  RingContact::RingContact(const MotorInUse &in_use, const RotorLoad &load,
                           const SteadyStep &steady_step,
                           std::shared_ptr<const SteadyDynamics> with_inertia)
      : motor(in_use.bodies), wave(in_use.wave), load(load), fold(motor.n_repeats()),
        n_sectors(motor.n_teeth / fold), n_nodes(motor.nodes.size()),
        n_samples(steady_step.n_samples), step(step_length(motor, wave, steady_step)),
        steady_neighbour(steady_step.n_joined * ringmotor::steady_neighbour(motor) % n_sectors),
        // Forces that repeat themselves around the ring neither shift nor tilt the rotor.
        n_rigid_of_sample(fold > 1 ? 1 : 1 + 2 * motor.near_rigid_modes.size()),
        dynamics(std::move(with_inertia)),
        compliance(dynamics
                       ? std::shared_ptr<const BlockCompliance>(dynamics, &dynamics->compliance)
                       : std::make_shared<const BlockCompliance>(motor.repeating(), n_samples))
  {
    Assert(n_samples == 1 || steady_step.n_joined == 1, ExcMessage("one sample, or short steps"));
    place_stator(0., Warp());
    tabulate_rigid_motions();
  }

  RingContact::RingContact(const MotorInUse &in_use, const RotorLoad &load,
                           const TimeStep &time_step, const Warp &warp)
      : motor(in_use.bodies), wave(in_use.wave), load(load), fold(1), n_sectors(motor.n_teeth),
        n_nodes(motor.nodes.size()), n_samples(1), step(time_step.length), given(time_step.earlier),
        steady_neighbour(0), n_rigid_of_sample(1 + 2 * motor.near_rigid_modes.size()),
        compliance(time_step.compliance
                       ? time_step.compliance
                       : std::make_shared<const BlockCompliance>(motor.compliance, n_samples)),
        vibration(time_step.vibration), rigid_inertia(time_step.rigid_inertia)
  {
    place_stator(time_step.time, warp);
    tabulate_rigid_motions();
  }

  void RingContact::place_stator(const double first_time, const Warp &warp)
  {
    for (unsigned int point = 0; point < n_points(); ++point)
    {
      const double phase = wave.angular_frequency * (first_time + sample(point) * step) -
                           motor.n_waves * motor.pitch() * tooth(point);
      PointVector motion;
      for (unsigned int c = 0; c < 3; ++c)
        motion[c] = (wave.free_motion[point % n_nodes][c] * std::polar(1., phase)).real();
      motion[0] += warp.height(motor.pitch() * tooth(point) + node(point).angle);
      stator.push_back(motion);
    }
  }

  void RingContact::tabulate_rigid_motions()
  {
    for (unsigned int point = 0; point < n_sectors * n_nodes; ++point)
    {
      PointVector rise;
      rise[0] = 1.;
      rigid.push_back(rise);
      const std::complex<double> phase = std::polar(1., -motor.pitch() * tooth(point));
      for (unsigned int i = 0; 2 * i + 1 < n_rigid_of_sample; ++i)
      {
        PointVector cosine, sine;
        for (unsigned int c = 0; c < 3; ++c)
        {
          const std::complex<double> motion =
              phase * motor.near_rigid_modes[i].motion[point % n_nodes][c];
          cosine[c] = motion.real();
          sine[c]   = -motion.imag();
        }
        rigid.push_back(cosine);
        rigid.push_back(sine);
      }
    }
  }

  unsigned int RingContact::earlier(const unsigned int point) const
  {
    const unsigned int n_of_sample = n_sectors * n_nodes;
    if (sample(point) > 0)
      return point - n_of_sample;
    const unsigned int earlier_tooth = (tooth(point) + steady_neighbour) % n_sectors;
    return (n_samples - 1) * n_of_sample + earlier_tooth * n_nodes + point % n_nodes;
  }

  std::vector<PointVector> RingContact::positions_by(const ContactState &state) const
  {
    std::vector<PointVector> position(n_points());
    for (unsigned int point = 0; point < position.size(); ++point)
      for (unsigned int r = 0; r < n_rigid_of_sample; ++r)
        position[point] +=
            state.rigid[sample(point) * n_rigid_of_sample + r] * rigid_motion(point, r);
    compliance->add_motions(state.force, position);
    return position;
  }

  ModalPower RingContact::modal_power(const ContactState &state) const
  {
    return dynamics ? dynamics->inertia.power(compliance->by_instant(state.force)) : ModalPower();
  }

  std::vector<PointVector> RingContact::modal_motion(const ContactState &state) const
  {
    return dynamics
               ? compliance->by_point(dynamics->inertia.motion(compliance->by_instant(state.force)))
               : std::vector<PointVector>();
  }

  std::vector<std::complex<double>> RingContact::vibration_of_modes(const ContactState &state) const
  {
    return dynamics ? dynamics->inertia.vibration(compliance->by_instant(state.force), n_samples)
                    : std::vector<std::complex<double>>();
  }

  std::vector<std::vector<ModalState>> RingContact::modal_states(const ContactState &state) const
  {
    return dynamics ? dynamics->inertia.states(compliance->by_instant(state.force))
                    : std::vector<std::vector<ModalState>>();
  }

  std::vector<PointVector> RingContact::positions(const ContactState &state) const
  {
    std::vector<PointVector> position = positions_by(state);
    for (unsigned int point = 0; point < position.size(); ++point)
    {
      position[point] -= vibration.empty() ? stator[point] : stator[point] - vibration[point];
      position[point][0] += gap(point);
    }
    return position;
  }

  std::vector<PointVector> RingContact::tooth_motion(const ContactState &state) const
  {
    std::vector<PointVector> motion = stator;
    for (unsigned int j = 0; j < state.force.size(); ++j)
      if (state.force[j] != PointVector())
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int c = 0; c < 3; ++c)
            for (unsigned int d = 0; d < 3; ++d)
              motion[j - j % n_nodes + a][c] -=
                  motor.tooth_compliance(3 * a + c, 3 * (j % n_nodes) + d) * state.force[j][d];
    return motion;
  }

  std::vector<PointVector> RingContact::rotor_motion(const ContactState &state) const
  {
    std::vector<PointVector> motion             = positions(state);
    const std::vector<PointVector> tooth_motion = this->tooth_motion(state);
    for (unsigned int point = 0; point < motion.size(); ++point)
    {
      motion[point] += tooth_motion[point];
      motion[point][0] -= gap(point);
    }
    return motion;
  }

  std::vector<PointVector> RingContact::relative_motion(const ContactState &state) const
  {
    return change_in_step(positions(state), given ? &*given : nullptr, turn(state));
  }

  std::vector<PointVector> RingContact::motion_by(const ContactState &change) const
  {
    const std::vector<PointVector> at_rest(given ? n_points() : 0);
    return change_in_step(positions_by(change), given ? &at_rest : nullptr,
                          load.torque ? change.rigid.back() : 0.);
  }

  std::vector<PointVector> RingContact::change_in_step(const std::vector<PointVector> &position,
                                                       const std::vector<PointVector> *before,
                                                       const double turned) const
  {
    std::vector<PointVector> motion = position;
    for (unsigned int point = 0; point < motion.size(); ++point)
    {
      const PointVector &start = before ? (*before)[point] : position[earlier(point)];
      for (unsigned int c = 1; c < 3; ++c)
        motion[point][c] -= start[c];
      motion[point][1] += node(point).radius * turned;
    }
    return motion;
  }

  void RingContact::derivatives(const std::vector<unsigned int> &row_points,
                                const std::vector<unsigned int> &column_points,
                                FullMatrix<double> &matrix) const
  {
    const unsigned int n = column_points.size();
    matrix.reinit(3 * row_points.size(), 3 * n + n_rigid());
    const auto add_rigid = [&](const unsigned int point, const double factor,
                               const unsigned int row, const unsigned int first)
    {
      for (unsigned int r = 0; r < n_rigid_of_sample; ++r)
        for (unsigned int c = first; c < 3; ++c)
          matrix(row + c, 3 * n + sample(point) * n_rigid_of_sample + r) +=
              factor * rigid_motion(point, r)[c];
    };
    const std::vector<PointsOfTooth> columns = by_tooth(column_points);
    for (const PointsOfTooth &rows : by_tooth(row_points))
    {
      add_elastic_rows(rows, rows.first_point, columns, 1., 0, matrix);
      if (!given)
        add_elastic_rows(rows, earlier(rows.first_point), columns, -1., 1, matrix);
    }
    for (unsigned int i = 0; i < row_points.size(); ++i)
    {
      add_rigid(row_points[i], 1., 3 * i, 0);
      if (!given)
        add_rigid(earlier(row_points[i]), -1., 3 * i, 1);
      if (load.torque)
        matrix(3 * i + 1, 3 * n + n_rigid() - 1) = node(row_points[i]).radius;
    }
  }

  std::vector<RingContact::PointsOfTooth>
  RingContact::by_tooth(const std::vector<unsigned int> &points) const
  {
    std::vector<PointsOfTooth> teeth;
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      if (i == 0 || points[i] / n_nodes != points[i - 1] / n_nodes)
        teeth.push_back({points[i], i, {}});
      teeth.back().nodes.push_back(points[i] % n_nodes);
    }
    return teeth;
  }

  void RingContact::add_elastic_rows(const PointsOfTooth &rows, const unsigned int at,
                                     const std::vector<PointsOfTooth> &columns, const double factor,
                                     const unsigned int first, FullMatrix<double> &matrix) const
  {
    for (const PointsOfTooth &loaded : columns)
      compliance->add_entries(at / n_nodes, loaded.first_point / n_nodes, rows.nodes, loaded.nodes,
                              factor, first, matrix, 3 * rows.first, 3 * loaded.first);
  }

  std::vector<double> RingContact::balances(const ContactState &state) const
  {
    std::vector<double> balances(n_rigid(), 0.);
    for (unsigned int point = 0; point < state.force.size(); ++point)
      for (unsigned int r = 0; r < n_rigid_of_sample; ++r)
        balances[sample(point) * n_rigid_of_sample + r] +=
            rigid_motion(point, r) * state.force[point];
    for (unsigned int m = 0; m < n_samples; ++m)
    {
      const unsigned int first = m * n_rigid_of_sample;
      balances[first] -= load.preload / fold;
      for (unsigned int r = 0; r < n_rigid_of_sample; ++r)
      {
        double &balance = balances[first + r];
        balance -= rigid_stiffness(r) * state.rigid[first + r] -
                   (rigid_inertia.empty() ? 0. : rigid_inertia[r].load);
        balance *= balance_factor(r);
      }
    }
    if (load.torque) // as a force at the contact radius, comparable with the others
      balances.back() = (torque(state) - *load.torque) / fold / motor.nodes.front().radius;
    return balances;
  }

  void RingContact::balance_derivatives(const std::vector<unsigned int> &points,
                                        FullMatrix<double> &matrix) const
  {
    matrix.reinit(n_rigid(), 3 * points.size() + n_rigid());
    for (unsigned int m = 0; m < n_samples; ++m)
      for (unsigned int r = 0; r < n_rigid_of_sample; ++r)
      {
        const unsigned int row               = m * n_rigid_of_sample + r;
        matrix(row, 3 * points.size() + row) = -balance_factor(r) * rigid_stiffness(r);
      }
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      for (unsigned int r = 0; r < n_rigid_of_sample; ++r)
        for (unsigned int c = 0; c < 3; ++c)
          matrix(sample(points[i]) * n_rigid_of_sample + r, 3 * i + c) =
              balance_factor(r) * rigid_motion(points[i], r)[c];
      if (load.torque)
        matrix(n_rigid() - 1, 3 * i + 1) =
            node(points[i]).radius / n_samples / motor.nodes.front().radius;
    }
  }

  double RingContact::torque(const ContactState &state) const
  {
    double sum = 0.;
    for (unsigned int point = 0; point < state.force.size(); ++point)
      sum += node(point).radius * state.force[point][1];
    return fold * sum / n_samples;
  }

  double RingContact::turn(const ContactState &state) const
  {
    return load.torque ? state.rigid.back() : load.speed * step;
  }

  double RingContact::speed(const ContactState &state) const
  {
    return turn(state) / step;
  }

  double RingContact::stored_energy(const ContactState &state) const
  {
    std::vector<PointVector> deflection(n_points());
    // Static only: the power that modes take beyond that is ModalPower.
    compliance->add_motions_at_once(state.force, deflection);
    double energy = 0.;
    for (unsigned int point = 0; point < n_points(); ++point)
      energy += 0.5 * (state.force[point] * deflection[point]);
    for (unsigned int m = 0; m < n_samples; ++m)
    {
      const double *motion = &state.rigid[m * n_rigid_of_sample];
      energy += load.preload / fold * motion[0];
      for (unsigned int r = 1; r < n_rigid_of_sample; ++r)
        energy += 0.5 * static_stiffness(r) * motion[r] * motion[r];
    }
    return fold * energy / n_samples;
  }

  ContactState RingContact::pressed_down() const
  {
    constexpr double share = 0.1;
    ContactState state{std::vector<PointVector>(n_points()), std::vector<double>(n_rigid(), 0.)};
    const unsigned int n_of_sample = n_sectors * n_nodes;
    for (unsigned int m = 0; m < n_samples; ++m)
    {
      std::vector<double> heights;
      for (unsigned int point = m * n_of_sample; point < (m + 1) * n_of_sample; ++point)
        heights.push_back(stator[point][0] - gap(point));
      const auto n_above = static_cast<std::ptrdiff_t>(1 + share * n_of_sample);
      std::nth_element(heights.begin(), heights.end() - n_above, heights.end());
      state.rigid[m * n_rigid_of_sample] = *(heights.end() - n_above);
    }
    return state;
  }
} // namespace ringmotor
