// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/results/estimate.h>

#include <array>
#include <complex>
#include <optional>
#include <string>

namespace ringmotor
{
  /** What the contact does to a wave that drives it, at some amplitude. */
  struct WaveLoad
  {
    double amplitude; ///< m, at the outer edge of the tooth tops
    double frequency; ///< rad/s, of the drive
    double detuning;  ///< see ringmotor::detuning()
    double power;     ///< W, taken from both standing waves, without the losses of the stator
  };

  /**
   * The forces on each of the two standing waves of a travelling wave, driven by equal voltages of
   * both phases a quarter of a period apart. In the steady state
   *
   *     eta V = |K| a,   K = m (omega_r^2 (1 + 2 delta) - omega^2) + i (P / (omega a^2) + h),
   *
   * with the amplitude a, the modal mass m, the force factor eta, the natural frequency omega_r at
   * short circuit, the detuning delta and the power P of the contact, and h = D / omega, D a^2 the
   * power lost in the stator and its felt. These are the two parts of the modal force of the
   * contact in the balance m (q'' + omega_r^2 q) + damping + contact = eta V(t).
   */
  struct VoltageDrive
  {
    double voltage = 0.;             ///< V, zero to peak, of each phase
    std::optional<double> frequency; ///< rad/s; none: the drive follows the resonance
    Estimate force_factor;           ///< N/V, the mean of both phases
    Estimate modal_mass;             ///< kg
    Estimate natural_frequency;      ///< rad/s, at short circuit and without rotor
    Estimate internal_loss;          ///< W/m^2: D

    double rotor_loss_factor = 0.; ///< of the damping that the rotor's power counts, see
                                   ///< power_per_loss_factor()

    /** K, in N/m. A drive that follows the resonance meets no spring. */
    std::complex<double> stiffness(const WaveLoad &load) const;

    /**
     * The logarithm of the voltage that @p load needs over the given one: 0 in the steady state;
     * where it is negative, at least -1, the wave grows. If the rotor feeds more power into the
     * wave than it loses, the voltage has to balance the spring alone.
     * @param with_errors the given voltage is raised by as much as the errors of this drive may
     * lower the one that is needed
     */
    double excess(const WaveLoad &load, const bool with_errors) const;

    /** The frequencies (rad/s) below and above the resonance at which the voltage sustains the
     * amplitude of @p load, with the same work of the contact in a period; that of the resonance if
     * it needs more than the voltage. */
    std::array<double, 2> frequencies(const WaveLoad &load) const;

    /** The current of the motion over the voltage of a phase (S) at a frequency (rad/s), with the
     * same work of the contact in a period: i omega eta^2 / K. */
    std::complex<double> motional_admittance(const WaveLoad &load, const double at_frequency) const;

    /** The real part of K with its error (N/m), exactly 0 for a drive that follows the resonance.
     * @param detuning with its error */
    Estimate spring(const WaveLoad &load, const Estimate &detuning) const;

    /** Identifies all of it. */
    std::string text() const;

  private:
    double detuned_square(const WaveLoad &load) const; ///< rad^2/s^2: omega_r^2 (1 + 2 delta)
    double available(const WaveLoad &load) const;      ///< N/m: eta V / a
    double damper(const WaveLoad &load) const;         ///< N/m: the imaginary part of K
  };
} // namespace ringmotor
