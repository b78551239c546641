// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/condensed_motor.h>

#include <optional>
#include <vector>

namespace ringmotor
{
  /** What loads the rotor at an operating point. */
  struct RotorLoad
  {
    double preload;               ///< N
    std::optional<double> torque; ///< N m, if it is given; opposes the motion
    double speed = 0.;            ///< rad/s, if no torque is given
  };

  /** Tangential positions of the rotor over the stator at the end of a step, by point. */
  using TangentialPositions = std::vector<dealii::Tensor<1, 2>>;

  /**
   * All teeth of a motor in contact with its rotor, at one or several moments.
   *
   * *Steady state* of a uniform ring. n waves and N teeth repeat themselves after P = N / gcd(n, N)
   * teeth, and T/P later each tooth is where its s-th neighbour was, n s = gcd(n, N) (mod N). One
   * moment shows the whole period; S moments, T/(P S) apart, show it more finely. The slip of a
   * point in a step is the difference of its positions at one moment and at the one before or, at
   * the first moment, of its s-th neighbour at the last one. The rotor turns at an even speed.
   *
   * *One step* from given positions.
   *
   * Points are numbered by moment, tooth, node. Rigid motions are, for each moment, the rotor's
   * rise (m) and, for a rotor without bars, its shifts (m) and tilts (rad) by two axes; at last, if
   * the torque is given, its turn (rad) in a step.
   */
  class RingContact : public ContactProblem
  {
  public:
    /** The steady state with @p n_moments moments. @p motor must outlive this object. */
    RingContact(const CondensedMotor &motor, const RotorLoad &load, const unsigned int n_moments);

    unsigned int n_points() const override { return n_moments * n_sectors * n_nodes; }
    unsigned int n_rigid() const override
    {
      return n_moments * n_rigid_of_moment + (load.torque ? 1 : 0);
    }
    std::vector<PointVector> relative_motion(const ContactState &state) const override;
    void derivatives(const std::vector<unsigned int> &points,
                     dealii::FullMatrix<double> &matrix) const override;
    std::vector<double> balances(const ContactState &state) const override;
    void balance_derivatives(const std::vector<unsigned int> &points,
                             dealii::FullMatrix<double> &matrix) const override;

    /** s, from one step to the next. */
    double time_step() const { return step; }
    const CondensedMotor &condensed_motor() const { return motor; }
    /** Teeth after which all repeats itself, and how often it does around the ring. */
    unsigned int n_teeth() const { return n_sectors; }
    unsigned int n_repeats() const { return fold; }
    unsigned int n_times() const { return n_moments; }

    /** The point that was one step earlier what this one is now. */
    unsigned int earlier(const unsigned int point) const;
    /** The node of the motor of a point. */
    const CondensedMotor::Node &node(const unsigned int point) const
    {
      return motor.nodes[point % n_nodes];
    }
    /** How the stator moves a point (m) without contact forces. */
    PointVector free_motion(const unsigned int point) const;

    /** Torque (N m) of friction on the rotor, the mean over all moments. */
    double torque(const ContactState &state) const;
    /** rad/s */
    double speed(const ContactState &state) const;

    /** A state from which the solver can start: no forces, the rotor pressed into the teeth by
     * @p depth (m). */
    ContactState pressed_down(const double depth) const;

  private:
    double turn(const ContactState &state) const;
    /** Motion of all points under the forces, m. */
    std::vector<PointVector> elastic_motion(const std::vector<PointVector> &force) const;
    unsigned int moment(const unsigned int point) const { return point / (n_sectors * n_nodes); }
    unsigned int sector(const unsigned int point) const { return point / n_nodes % n_sectors; }
    /** Motion of a point by unit rigid motions of its moment. */
    std::vector<PointVector> rigid_motions(const unsigned int point) const;
    /** The stiffness against a rigid motion of a moment. */
    double rigid_stiffness(const unsigned int motion) const
    {
      return motion == 0 ? 0. : motor.loose_motions[(motion - 1) / 2].stiffness;
    }
    /** Adds factor times the compliance between two points of one moment. */
    void add_compliance(const unsigned int row_point, const unsigned int column_point,
                        const double factor, const unsigned int first_component,
                        dealii::Tensor<2, 3> &block) const;

    const CondensedMotor &motor;
    const RotorLoad load;
    const unsigned int fold, n_sectors, n_nodes, n_moments;
    const double step;
    unsigned int neighbour;         ///< s
    unsigned int n_rigid_of_moment; ///< of the rotor at one moment
    RingCompliance compliance;
    std::vector<PointVector> stator_motion; ///< of all points without contact forces
  };
} // namespace ringmotor
