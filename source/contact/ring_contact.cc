// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/ring_contact.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ringmotor
{
  using namespace dealii;

  RingContact::RingContact(const CondensedMotor &motor, const RotorLoad &load,
                           const unsigned int n_moments)
      : motor(motor), load(load), fold(std::gcd(motor.n_waves, motor.n_teeth)),
        n_sectors(motor.n_teeth / fold), n_nodes(motor.nodes.size()), n_moments(n_moments),
        step(motor.period() / (n_sectors * n_moments)), compliance(motor.compliance.folded(fold))
  {
    // n s = gcd(n, N) (mod N)
    for (neighbour = 0; motor.n_waves * neighbour % motor.n_teeth != fold; ++neighbour)
      ;
    neighbour %= n_sectors;
    // Forces that repeat themselves around the ring shift and tilt nothing.
    n_rigid_of_moment = fold > 1 ? 1 : 1 + 2 * motor.loose_motions.size();
    for (unsigned int point = 0; point < n_points(); ++point)
    {
      const double phase = 2. * numbers::PI *
                           (moment(point) / static_cast<double>(n_sectors * n_moments) -
                            motor.n_waves * static_cast<double>(sector(point)) / motor.n_teeth);
      PointVector motion;
      for (unsigned int c = 0; c < 3; ++c)
        motion[c] = (node(point).free_motion[c] * std::polar(1., phase)).real();
      stator_motion.push_back(motion);
    }
  }

  unsigned int RingContact::earlier(const unsigned int point) const
  {
    const unsigned int n_of_moment = n_sectors * n_nodes;
    if (moment(point) > 0)
      return point - n_of_moment;
    const unsigned int tooth = (sector(point) + neighbour) % n_sectors;
    return (n_moments - 1) * n_of_moment + tooth * n_nodes + point % n_nodes;
  }

  PointVector RingContact::free_motion(const unsigned int point) const
  {
    return stator_motion[point];
  }

  std::vector<PointVector> RingContact::rigid_motions(const unsigned int point) const
  {
    std::vector<PointVector> motions(n_rigid_of_moment);
    motions[0][0]                    = 1.;
    const std::complex<double> phase = std::polar(1., -motor.pitch() * sector(point));
    for (unsigned int i = 1; i < n_rigid_of_moment; i += 2)
      for (unsigned int c = 0; c < 3; ++c)
      {
        const std::complex<double> motion =
            phase * motor.loose_motions[i / 2].motion[point % n_nodes][c];
        motions[i][c]     = motion.real();
        motions[i + 1][c] = -motion.imag();
      }
    return motions;
  }

  std::vector<PointVector> RingContact::elastic_motion(const std::vector<PointVector> &force) const
  {
    std::vector<PointVector> motion(n_points());
    for (unsigned int j = 0; j < force.size(); ++j)
      if (force[j] != PointVector())
      {
        const unsigned int first = moment(j) * n_sectors * n_nodes, b = j % n_nodes;
        for (unsigned int tooth = 0; tooth < n_sectors; ++tooth)
        {
          const unsigned int distance = (tooth + n_sectors - sector(j)) % n_sectors;
          for (unsigned int a = 0; a < n_nodes; ++a)
          {
            PointVector &moved = motion[first + tooth * n_nodes + a];
            for (unsigned int c = 0; c < 3; ++c)
              for (unsigned int d = 0; d < 3; ++d)
                moved[c] += compliance(distance, a, c, b, d) * force[j][d];
          }
        }
      }
    return motion;
  }

  std::vector<PointVector> RingContact::relative_motion(const ContactState &state) const
  {
    std::vector<PointVector> position = elastic_motion(state.force);
    for (unsigned int point = 0; point < position.size(); ++point)
    {
      position[point] -= stator_motion[point];
      const std::vector<PointVector> rigid = rigid_motions(point);
      for (unsigned int r = 0; r < n_rigid_of_moment; ++r)
        position[point] += state.rigid[moment(point) * n_rigid_of_moment + r] * rigid[r];
    }
    const double turned             = turn(state);
    std::vector<PointVector> motion = position;
    for (unsigned int point = 0; point < motion.size(); ++point)
    {
      const PointVector &before = position[earlier(point)];
      for (unsigned int c = 1; c < 3; ++c)
        motion[point][c] -= before[c];
      motion[point][1] += node(point).radius * turned;
    }
    return motion;
  }

  void RingContact::add_compliance(const unsigned int row_point, const unsigned int column_point,
                                   const double factor, const unsigned int first_component,
                                   Tensor<2, 3> &block) const
  {
    if (moment(row_point) != moment(column_point))
      return;
    const unsigned int distance =
        (sector(row_point) + n_sectors - sector(column_point)) % n_sectors;
    for (unsigned int c = first_component; c < 3; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        block[c][d] +=
            factor * compliance(distance, row_point % n_nodes, c, column_point % n_nodes, d);
  }

  void RingContact::derivatives(const std::vector<unsigned int> &points,
                                FullMatrix<double> &matrix) const
  {
    const unsigned int n = points.size();
    matrix.reinit(3 * n, 3 * n + n_rigid());
    for (unsigned int i = 0; i < n; ++i)
    {
      const unsigned int before = earlier(points[i]);
      for (unsigned int j = 0; j < n; ++j)
      {
        Tensor<2, 3> block;
        add_compliance(points[i], points[j], 1., 0, block);
        add_compliance(before, points[j], -1., 1, block);
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int d = 0; d < 3; ++d)
            matrix(3 * i + c, 3 * j + d) = block[c][d];
      }
      const std::vector<PointVector> now     = rigid_motions(points[i]);
      const std::vector<PointVector> earlier = rigid_motions(before);
      for (unsigned int r = 0; r < n_rigid_of_moment; ++r)
      {
        for (unsigned int c = 0; c < 3; ++c)
          matrix(3 * i + c, 3 * n + moment(points[i]) * n_rigid_of_moment + r) += now[r][c];
        for (unsigned int c = 1; c < 3; ++c)
          matrix(3 * i + c, 3 * n + moment(before) * n_rigid_of_moment + r) -= earlier[r][c];
      }
      if (load.torque)
        matrix(3 * i + 1, 3 * n + n_rigid() - 1) = node(points[i]).radius;
    }
  }

  std::vector<double> RingContact::balances(const ContactState &state) const
  {
    std::vector<double> balances(n_rigid(), 0.);
    for (unsigned int point = 0; point < state.force.size(); ++point)
      if (state.force[point] != PointVector())
      {
        const std::vector<PointVector> rigid = rigid_motions(point);
        for (unsigned int r = 0; r < n_rigid_of_moment; ++r)
          balances[moment(point) * n_rigid_of_moment + r] += rigid[r] * state.force[point];
      }
    for (unsigned int m = 0; m < n_moments; ++m)
    {
      const unsigned int first = m * n_rigid_of_moment;
      balances[first] -= load.preload / fold;
      for (unsigned int r = 1; r < n_rigid_of_moment; ++r)
        balances[first + r] -= rigid_stiffness(r) * state.rigid[first + r];
    }
    if (load.torque) // as a force at the mean radius of contact, to be compared with the others
      balances.back() = (torque(state) - *load.torque) / fold / motor.nodes.front().radius;
    return balances;
  }

  void RingContact::balance_derivatives(const std::vector<unsigned int> &points,
                                        FullMatrix<double> &matrix) const
  {
    matrix.reinit(n_rigid(), 3 * points.size() + n_rigid());
    for (unsigned int m = 0; m < n_moments; ++m)
      for (unsigned int r = 0; r < n_rigid_of_moment; ++r)
      {
        const unsigned int row               = m * n_rigid_of_moment + r;
        matrix(row, 3 * points.size() + row) = -rigid_stiffness(r);
      }
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      const std::vector<PointVector> rigid = rigid_motions(points[i]);
      for (unsigned int r = 0; r < n_rigid_of_moment; ++r)
        for (unsigned int c = 0; c < 3; ++c)
          matrix(moment(points[i]) * n_rigid_of_moment + r, 3 * i + c) = rigid[r][c];
      if (load.torque)
        matrix(n_rigid() - 1, 3 * i + 1) =
            node(points[i]).radius / n_moments / motor.nodes.front().radius;
    }
  }

  double RingContact::torque(const ContactState &state) const
  {
    double sum = 0.;
    for (unsigned int point = 0; point < state.force.size(); ++point)
      sum += node(point).radius * state.force[point][1];
    return fold * sum / n_moments;
  }

  double RingContact::turn(const ContactState &state) const
  {
    return load.torque ? state.rigid.back() : load.speed * step;
  }

  double RingContact::speed(const ContactState &state) const
  {
    return turn(state) / step;
  }

  ContactState RingContact::pressed_down(const double depth) const
  {
    ContactState state{std::vector<PointVector>(n_points()), std::vector<double>(n_rigid(), 0.)};
    double highest = 0.;
    for (const PointVector &motion : stator_motion)
      highest = std::max(highest, motion[0]);
    for (unsigned int m = 0; m < n_moments; ++m)
      state.rigid[m * n_rigid_of_moment] = highest - depth;
    return state;
  }
} // namespace ringmotor
