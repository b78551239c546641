// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/rigid_inertia.h>
#include <ringmotor/motor/steady_dynamics.h>
#include <ringmotor/motor/warp.h>

#include <memory>
#include <optional>
#include <vector>

namespace ringmotor
{
  /** The load on the rotor at an operating point. */
  struct RotorLoad
  {
    double preload;               ///< N
    std::optional<double> torque; ///< N m, if it is given; opposes the motion
    double speed = 0.;            ///< rad/s, if no torque is given
  };

  /** One step in time from a known state. */
  struct TimeStep
  {
    double time;                      ///< s, at its end
    double length;                    ///< s
    std::vector<PointVector> earlier; ///< positions at its begin, see RingContact::positions()
    /** For a motor with inertia: the compliance within the step, and the motion of the rotor at its
     * end (m) without forces there. */
    std::shared_ptr<const BlockCompliance> compliance = nullptr;
    std::vector<PointVector> vibration                = {};
    /** By rigid motion; empty if these are quasi-static. */
    std::vector<InertiaInStep> rigid_inertia = {};
  };

  /**
   * All teeth of a motor in contact with its rotor, at one or several time samples.
   *
   * *Steady state* of a uniform ring. n waves and N teeth repeat themselves after P = N / gcd(n, N)
   * teeth, and T/P ago each tooth was where its s-th neighbour is now, n s = gcd(n, N) (mod N). One
   * time sample covers the whole period; S time samples, T/(P S) apart, resolve it more finely. The
   * slip of a contact point in a step is the difference of its positions at a time sample and at
   * the previous one or, at the first, of its s-th neighbour at the last one. With a single time
   * sample, J steps may be joined to a longer one, which refers to the (J s)-th neighbour. The
   * rotor turns at constant speed.
   *
   * *One step* from a known state, of a ring that need not be uniform.
   *
   * Contact points are numbered by time sample, tooth, node. Rigid motions are, for each time
   * sample, the rotor's rise (m) and the cosine and sine parts of its near-rigid modes; and last,
   * if the torque is given, its rotation (rad) in a step.
   */
  class RingContact : public ContactProblem, public BlockStructure
  {
  public:
    /** The steady state with steps of a given length. @p motor must outlive this object.
     * @param dynamics of a motor with inertia, for the same step */
    RingContact(const MotorInUse &motor, const RotorLoad &load, const SteadyStep &step,
                std::shared_ptr<const SteadyDynamics> dynamics = nullptr);

    /** One step of a ring that may be warped at rest. */
    RingContact(const MotorInUse &motor, const RotorLoad &load, const TimeStep &step,
                const Warp &warp);

    unsigned int n_points() const override { return n_samples * n_sectors * n_nodes; }
    unsigned int n_rigid() const override
    {
      return n_samples * n_rigid_of_sample + (load.torque ? 1 : 0);
    }
    std::vector<PointVector> relative_motion(const ContactState &state) const override;
    std::vector<PointVector> motion_by(const ContactState &change) const override;
    void derivatives(const std::vector<unsigned int> &rows,
                     const std::vector<unsigned int> &columns,
                     dealii::FullMatrix<double> &matrix) const override;
    const BlockStructure &structure() const override { return *this; }
    unsigned int part_of_point(const unsigned int point) const override
    {
      return compliance->part_of(point / n_nodes);
    }
    unsigned int part_of_rigid(const unsigned int motion) const override
    {
      // The rotation belongs to all time samples.
      return motion < n_samples * n_rigid_of_sample
                 ? compliance->part_of(motion / n_rigid_of_sample * n_sectors)
                 : no_part;
    }
    unsigned int n_blocks() const override { return n_samples * n_sectors; }
    unsigned int block_of_point(const unsigned int point) const override { return point / n_nodes; }
    unsigned int block_before(const unsigned int block) const override
    {
      return given ? no_part : earlier(block * n_nodes) / n_nodes;
    }
    unsigned int n_far_shapes() const override { return compliance->far_shapes().n(); }
    double far_shape(const unsigned int point, const unsigned int component,
                     const unsigned int shape) const override
    {
      return compliance->far_shapes()(3 * (point % n_nodes) + component, shape);
    }
    const dealii::FullMatrix<double> *far_kernel(const unsigned int moved,
                                                 const unsigned int loaded) const override
    {
      return compliance->far_kernel(moved, loaded);
    }
    std::vector<double> balances(const ContactState &state) const override;
    void balance_derivatives(const std::vector<unsigned int> &points,
                             dealii::FullMatrix<double> &matrix) const override;

    /** s, from one step to the next. */
    double time_step() const { return step; }
    const CondensedMotor &condensed_motor() const { return motor; }
    const WaveAtNodes &stator_wave() const { return wave; }
    /** Number of teeth after which the motion repeats, and of repetitions around the ring. */
    unsigned int n_repeating_teeth() const { return n_sectors; }
    unsigned int n_repeats() const { return fold; }
    unsigned int n_time_samples() const { return n_samples; }
    /** Number of rigid motions of the rotor at one time sample. */
    unsigned int n_rigid_motions() const { return n_rigid_of_sample; }

    unsigned int sample(const unsigned int point) const { return point / (n_sectors * n_nodes); }
    unsigned int tooth(const unsigned int point) const { return point / n_nodes % n_sectors; }
    const CondensedMotor::Node &node(const unsigned int point) const
    {
      return motor.nodes[point % n_nodes];
    }
    /** In the steady state: the contact point whose state is that of this one a step earlier. */
    unsigned int earlier(const unsigned int point) const;
    /** Displacement of the stator at a contact point (m, relative to a ring at rest without warp)
     * without contact forces. */
    const PointVector &free_motion(const unsigned int point) const { return stator[point]; }

    /** Displacements of the teeth and of the rotor, without its rotation, at all points (m). */
    std::vector<PointVector> tooth_motion(const ContactState &state) const;
    std::vector<PointVector> rotor_motion(const ContactState &state) const;
    /** Positions of the rotor relative to the stator (m), without the rotation of the rotor. */
    std::vector<PointVector> positions(const ContactState &state) const;
    /** Torque (N m) of friction on the rotor, the mean over all time samples. */
    double torque(const ContactState &state) const;
    /** rad/s */
    double speed(const ContactState &state) const;
    /** Energy (J) of the whole ring, the mean over all time samples: elastic energy in all
     * compliance at the contact points and in the stiffness of the near-rigid modes; potential
     * energy of the preload by the rotor's rise. */
    double stored_energy(const ContactState &state) const;

    /** In the steady state: the power that the modes take, the motions of all contact points in
     * them (m), their amplitudes at all time samples, see SteadyInertia::vibration(), and their
     * states at the first one. Empty without modes. */
    ModalPower modal_power(const ContactState &state) const;
    std::vector<PointVector> modal_motion(const ContactState &state) const;
    std::vector<std::complex<double>> vibration_of_modes(const ContactState &state) const;
    std::vector<std::vector<ModalState>> modal_states(const ContactState &state) const;

    /** An initial state for the solver: no forces, the rotor so low that a small share of the
     * contact points would touch. */
    ContactState pressed_down() const;

  private:
    void place_stator(const double first_time, const Warp &warp);
    /** m, of the faces at rest at a contact point, see RestGap. */
    double gap(const unsigned int point) const
    {
      return motor.gap.at(point % n_nodes, load.preload);
    }
    void tabulate_rigid_motions();
    double turn(const ContactState &state) const;
    /** Positions due to forces and rigid motions only, and the change of positions in a step. */
    std::vector<PointVector> positions_by(const ContactState &state) const;
    std::vector<PointVector> change_in_step(const std::vector<PointVector> &position,
                                            const std::vector<PointVector> *before,
                                            const double turned) const;
    const PointVector &rigid_motion(const unsigned int point, const unsigned int which) const
    {
      return rigid[point % (n_sectors * n_nodes) * n_rigid_of_sample + which];
    }
    /** The stiffness of a rigid motion at a time sample, without and with inertia in a step. */
    double static_stiffness(const unsigned int motion) const
    {
      return motion == 0 ? 0. : motor.near_rigid_modes[(motion - 1) / 2].stiffness;
    }
    double rigid_stiffness(const unsigned int motion) const
    {
      return static_stiffness(motion) +
             (rigid_inertia.empty() ? 0. : rigid_inertia[motion].stiffness);
    }
    /** Scaling of a balance: reduces the huge inertial stiffness of a rigid motion in a short step
     * to the order of the stiffness of a contact point. */
    double balance_factor(const unsigned int motion) const
    {
      return rigid_inertia.empty()
                 ? 1.
                 : 1. / (1. + rigid_inertia[motion].stiffness / motor.constants.normal);
    }
    /** Consecutive points of a list that belong to one tooth at one time sample. */
    struct PointsOfTooth
    {
      unsigned int first_point;        ///< of the tooth, identifies tooth and time sample
      unsigned int first;              ///< position of the first one in the list
      std::vector<unsigned int> nodes; ///< of the tooth
    };
    std::vector<PointsOfTooth> by_tooth(const std::vector<unsigned int> &points) const;
    /** Adds @p factor times the motions of the nodes of @p rows, on the tooth and at the time
     * sample of the point @p at, due to forces on the points @p columns; only components from
     * @p first on. */
    void add_elastic_rows(const PointsOfTooth &rows, const unsigned int at,
                          const std::vector<PointsOfTooth> &columns, const double factor,
                          const unsigned int first, dealii::FullMatrix<double> &matrix) const;

    const CondensedMotor &motor;
    const WaveAtNodes wave;
    const RotorLoad load;
    const unsigned int fold, n_sectors, n_nodes, n_samples;
    const double step;
    const std::optional<std::vector<PointVector>> given; ///< positions at the step's begin
    unsigned int steady_neighbour;
    unsigned int n_rigid_of_sample; ///< of the rotor at one time sample
    const std::shared_ptr<const SteadyDynamics> dynamics;
    const std::shared_ptr<const BlockCompliance> compliance;
    std::vector<PointVector> stator; ///< motion of all contact points without contact forces
    const std::vector<PointVector> vibration; ///< of the rotor without forces, if it has inertia
    const std::vector<InertiaInStep> rigid_inertia; ///< likewise; or empty
    std::vector<PointVector> rigid; ///< of the points of a time sample by unit rigid motions
  };
} // namespace ringmotor
