// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <complex>

namespace ringmotor
{
  /**
   * The time integration of the motion of a mode,
   *
   *   m ((1 - alpha) a_1 + alpha a_0 + d v_1) + omega^2 q_1 = p_1,
   *   v_1 = v_0 + dt ((1 - gamma) a_0 + gamma a_1),
   *   q_1 = q_0 + dt v_0 + dt^2 ((1/2 - beta) a_0 + beta a_1),
   *
   * from 0 to 1 for displacement q, velocity v, acceleration a, force p (per mass), frequency omega
   * and damping d (1/s; a loss factor times omega). Newmark's method for alpha = 0; for alpha < 0
   * the method of Wood, Bossak and Zienkiewicz (1981), of second order for gamma = 1/2 - alpha. The
   * force at the end of a step moves the mode in that step, as contact requires. Impacts need
   * dissipation: without it, modes gain energy at each of them.
   *
   * Steps of these methods slow a mode down by about (omega dt)^2/12. That is more than the width
   * of a resonance, and impacts excite resonances of high harmonics: the mass factor m, one in the
   * limit of short steps, corrects it, see mass_factor().
   */
  struct InertiaScheme
  {
    double alpha = 0., gamma = 0.5, beta = 0.25;

    /** First order for @p gamma > 1/2, unconditionally stable. */
    static InertiaScheme newmark(const double gamma);
    /** Second order. Motions much faster than the step keep this share of their amplitude from one
     * step to the next; 0 .. 1. */
    static InertiaScheme second_order(const double spectral_radius);

    /** A scheme of the same order that dissipates markedly more or less: the difference of the
     * results shows how much dissipation matters. */
    InertiaScheme dissipating_otherwise() const;

    /** Displacement by force per mass, s^2, where each step multiplies both by @p z. */
    std::complex<double> response(const std::complex<double> &z, const double dt,
                                  const double frequency, const double damping) const;

    /** Velocity (1/s) and acceleration (1/s^2) by displacement in such a motion. */
    std::complex<double> velocity(const std::complex<double> &z, const double dt) const;
    std::complex<double> acceleration(const std::complex<double> &z, const double dt) const;

    /** The factor of a mode's mass for which motions with the mode's own frequency meet it in
     * resonance: inertia and stiffness balance. Its static motion remains exact. At most that of
     * two radians in a step, where the mode is hardly resolved. */
    double mass_factor(const double dt, const double frequency) const;

    /** Displacement at the end of a step by the force per mass there, s^2. */
    double response_in_step(const double dt, const double frequency, const double damping) const;
  };

  /** The scheme whose constants lie between those of two others, and its dissipation as well;
   * unconditionally stable if both are. @param share of the way from @p one to @p other */
  InertiaScheme between(const InertiaScheme &one, const InertiaScheme &other, const double share);

  /** The state of a mode at one time. */
  struct ModalState
  {
    std::complex<double> displacement, velocity, acceleration;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &displacement &velocity &acceleration;
    }
  };

  /** The state after a step @p dt (s) without a force at its end. */
  ModalState without_force(const InertiaScheme &scheme, const ModalState &begin, const double dt,
                           const double frequency, const double damping);

  /** Adds the contribution of a force (per mass) at the end of the step. */
  void add_force(const InertiaScheme &scheme, const std::complex<double> &force, const double dt,
                 const double frequency, const double damping, ModalState &end);
} // namespace ringmotor
