// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/steady.h>

#include <functional>
#include <memory>

namespace ringmotor
{
  /** Steady states of a motor with waves of any amplitude, at the frequency to which the contact
   * shifts them if the model has it so. Each search starts from the last state. */
  class LoadedWave
  {
  public:
    /** @p motor must outlive this object and all its states. */
    LoadedWave(const CondensedMotor &motor, const MotorModel &model, const SteadyStep &step);

    /** To set the start of the next search. */
    SteadyDriver &driver() { return *steady; }

    /** Begins the next search at the frequency of the wave without contact. */
    void forget_frequency() { frequency = motor.angular_frequency; }

    /** The state under a load with the wave at an @p amplitude (m).
     * @throws ComputationError if none is found */
    OperatingState at(const RotorLoad &load, const double amplitude);

  private:
    /** The state at the present #frequency. */
    OperatingState at_frequency(const RotorLoad &load, const double amplitude);

    const CondensedMotor &motor;
    const MotorModel model;
    const SteadyStep step;
    double frequency;                      ///< rad/s
    std::unique_ptr<CondensedMotor> other; ///< the motor with another wave, if there was one
    std::unique_ptr<SteadyDriver> steady;
  };

  /** What balanced_amplitude() finds. */
  struct BalancedAmplitude
  {
    double value; ///< m
    /** How far it may be from the balance, relative: by a step of the search or, where the forces
     * of the contact jump, by the width of the jump. */
    double uncertainty;

    /** The excess that may remain where the forces of the contact jump from one state to a
     * neighbouring one, as with static friction above dynamic friction. */
    static constexpr double largest_excess = 1e-2;
  };

  /**
   * The amplitude to which a driven wave grows or decays from @p start (m): where its excess
   * vanishes, see VoltageDrive::excess(). As the search follows the sign of the excess, the balance
   * that it finds is one in which the amplitude is stable.
   * @param excess of an amplitude (m); the last one for which it is called is the result
   * @throws ComputationError if the amplitude does not settle between a hundredth and a hundred
   * times @p start
   */
  BalancedAmplitude balanced_amplitude(const double start,
                                       const std::function<double(double)> &excess);
} // namespace ringmotor
