// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/steady.h>

namespace ringmotor
{
  /** What a motor does at an operating point, of the whole ring and averaged over time. */
  struct OperatingPoint
  {
    double speed  = 0.; ///< rad/s, in the driven direction
    double torque = 0.; ///< N m, of friction on the rotor
    /** The power balance, in W. Work in a step is that of the means of the forces at its both ends:
     * then elastic forces give back what they took. */
    double tangential_loss = 0., radial_loss = 0.; ///< of friction, by sliding along and across
    double input_power   = 0.; ///< of the feet, by the stator's forced motion on the contact forces
    double output_work   = 0.; ///< output_power(), step by step with these means of the torque
    double stored_power  = 0.; ///< by which stored energy grows, see RingContact::stored_energy()
    double modal_power   = 0.; ///< that the rotor's inertia and damping take
    double modal_damping = 0.; ///< by damping alone, by the loss factor
    double gross_power   = 0.; ///< the input power, all of its parts taken positive
    double closing_work = 0.; ///< of pressure on gaps that close or open in a step; in numbers only

    /** By how much the contact shifts the frequency of the stator's wave, relatively, see
     * ringmotor::detuning(). */
    double detuning = 0.;

    double teeth_in_contact = 0.; ///< per wave
    double stick_fraction   = 0.; ///< of the pressure force, on points that stick

    double friction_loss() const { return tangential_loss + radial_loss; }
    double output_power() const { return torque * speed; }
    /** Input power less output work, friction loss and stored power, over the larger of input power
     * and loss. Exactly, it is the work on closing gaps. */
    double power_imbalance() const;
    /** What a result may have of it. */
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
   * By how much the contact forces of a steady state shift the frequency of the wave, relatively,
   * if the drive keeps the amplitude and follows: W / (4 E), W the mean of the work that the forces
   * on the rotor would do in the motion of the stator, E the strain energy of the wave. For a
   * travelling wave q'' + omega^2 q = Q/m of each of its two modes says so; it is Rayleigh's
   * quotient of springs that press as the contact does.
   */
  double detuning(const OperatingState &state);

  /** Evaluates a steady state, which stores no power: a period later all energy is as it was. */
  OperatingPoint evaluate(const OperatingState &state);

  /** Evaluates one step from the state @p before. */
  OperatingPoint evaluate_step(const OperatingState &before, const OperatingState &state);

  /** The mean over the time of several steps of some @p lengths (s). */
  OperatingPoint mean(const std::vector<OperatingPoint> &points,
                      const std::vector<double> &lengths);
} // namespace ringmotor
