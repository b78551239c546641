// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/steady.h>
#include <ringmotor/points/node_pass.h>

namespace ringmotor
{
  /** The results of a motor at an operating point, for the whole ring and averaged over time. */
  struct OperatingPoint
  {
    double speed  = 0.; ///< rad/s, in the driven direction
    double torque = 0.; ///< N m, of friction on the rotor
    /** The power balance, in W. The work in a step is that of the means of the forces at its two
     * ends: elastic forces then return all the energy that they store. */
    double tangential_loss = 0., radial_loss = 0.; ///< of friction, by sliding along and across
    double input_power  = 0.; ///< of the feet, by the stator's forced motion on contact forces
    double output_work  = 0.; ///< output_power(), step by step with such means of the torque
    double stored_power = 0.; ///< growth rate of stored energy, see RingContact::stored_energy()
    double modal_power  = 0.; ///< taken by inertia and damping of the bodies
    double modal_damping =
        0.; ///< what the rotor's damping by a loss factor takes, over that factor
    double stator_damping = 0.; ///< what that of the stator's modes beside the wave takes
    double gross_power    = 0.; ///< exchanged by feet and forces: the input power, each node's part
                                ///< taken positive
    double closing_work = 0.;   ///< of pressure on gaps closing or opening in a step; numerical

    double amplitude = 0.; ///< m, of the wave, see StatorWave::amplitude
    /** The relative shift of the frequency of the stator's wave by the contact, see
     * ringmotor::detuning(). */
    double detuning = 0.;

    double teeth_in_contact      = 0.; ///< per wave
    double stick_fraction        = 0.; ///< of the pressure force, on points that stick
    double second_stick_fraction = 0.; ///< the same for the second time in a pass, see NodePass

    /** What the contact takes from the stator's wave (W), with @p rotor_loss in place of what the
     * rotor's damping took in the model. */
    double taken_from_wave(const double rotor_loss) const
    {
      return input_power - modal_power + rotor_loss + stator_damping;
    }
    double friction_loss() const { return tangential_loss + radial_loss; }
    /** Of the friction loss, by sliding across; 0 without loss. */
    double radial_loss_share() const
    {
      return friction_loss() > 0. ? radial_loss / friction_loss() : 0.;
    }
    double output_power() const { return torque * speed; }
    /** Input power less output work, friction loss, stored and modal power: up to solver errors the
     * work on closing gaps. */
    double missing_power() const;
    /** The same over the power that is exchanged, or the loss if larger: a rotor without load takes
     * little power, and one that hardly slips or moves none. */
    double power_imbalance() const;
    /** The largest admissible power_imbalance() of a result. */
    static constexpr double largest_imbalance = 1e-3;

    /** All numbers above: what point_quantities() lists of them, and those that only serve to
     * compute others. */
    static const std::vector<double OperatingPoint::*> &members();

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      for (double OperatingPoint::*const member : members())
        archive &this->*member;
    }
  };

  /**
   * The relative shift of the wave's frequency by the contact forces of a steady state, if the
   * drive keeps the amplitude and tracks the frequency: W / (4 E), W the mean of the work that the
   * forces on the rotor would do in the motion of the stator, E the strain energy of the wave. This
   * follows from q'' + omega^2 q = Q/m of each of the two modes of a travelling wave; it is
   * Rayleigh's quotient of springs that exert the contact forces.
   */
  double detuning(const OperatingState &state);

  /** Evaluates a steady state, which stores no power: its energy is periodic. */
  OperatingPoint evaluate(const OperatingState &state);

  /** Evaluates one step from the state @p before. @param pass what friction did until then */
  OperatingPoint evaluate_step(const OperatingState &before, const OperatingState &state,
                               const NodePass &pass);

  /** The time average over several steps of given @p lengths (s). */
  OperatingPoint mean(const std::vector<OperatingPoint> &points,
                      const std::vector<double> &lengths);
} // namespace ringmotor
