// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/inertia_scheme.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  namespace
  {
    using Complex = std::complex<double>;
  }

  InertiaScheme InertiaScheme::newmark(const double gamma)
  {
    return {0., gamma, 0.25 * std::pow(gamma + 0.5, 2)};
  }

  InertiaScheme InertiaScheme::second_order(const double spectral_radius)
  {
    const double alpha = (spectral_radius - 1.) / (spectral_radius + 1.);
    return {alpha, 0.5 - alpha, 0.25 * std::pow(1. - alpha, 2)};
  }

  InertiaScheme between(const InertiaScheme &one, const InertiaScheme &other, const double share)
  {
    return {(1. - share) * one.alpha + share * other.alpha,
            (1. - share) * one.gamma + share * other.gamma,
            (1. - share) * one.beta + share * other.beta};
  }

  InertiaScheme InertiaScheme::dissipating_otherwise() const
  {
    constexpr double markedly = 0.3;
    if (alpha == 0. && gamma > 0.5) // Newmark's method
      return newmark(0.5 * (0.5 + gamma));
    const double spectral_radius = (1. + alpha) / (1. - alpha);
    return second_order(spectral_radius + (spectral_radius > 0.5 ? -markedly : markedly));
  }

  namespace
  {
    /** Displacement by acceleration times (z - 1)^2, which vanishes at rest with the acceleration.
     */
    Complex by_acceleration(const InertiaScheme &scheme, const Complex &z, const double dt)
    {
      return dt * dt *
             (1. - scheme.gamma + scheme.gamma * z +
              (0.5 - scheme.beta + scheme.beta * z) * (z - 1.));
    }
  } // namespace

  Complex InertiaScheme::velocity(const Complex &z, const double dt) const
  {
    return dt * (1. - gamma + gamma * z) * (z - 1.) / by_acceleration(*this, z, dt);
  }

  Complex InertiaScheme::acceleration(const Complex &z, const double dt) const
  {
    return (z - 1.) * (z - 1.) / by_acceleration(*this, z, dt);
  }

  namespace
  {
    /** The acceleration in the equation of motion by displacement (1/s^2), see acceleration(). */
    Complex weighted_acceleration(const InertiaScheme &scheme, const Complex &z, const double dt)
    {
      return (1. - scheme.alpha + scheme.alpha / z) * scheme.acceleration(z, dt);
    }
  } // namespace

  Complex InertiaScheme::response(const Complex &z, const double dt, const double frequency,
                                  const double damping) const
  {
    const Complex inertia = weighted_acceleration(*this, z, dt) + damping * velocity(z, dt);
    return 1. / (mass_factor(dt, frequency) * inertia + frequency * frequency);
  }

  double InertiaScheme::mass_factor(const double dt, const double frequency) const
  {
    constexpr double longest = 2., shortest = 1e-5; // rad in a step; then the factor is 1
    const double phase = std::min(frequency * dt, longest);
    if (phase < shortest)
      return 1.;
    const Complex z = std::polar(1., phase);
    return -std::pow(phase / dt, 2) / weighted_acceleration(*this, z, dt).real();
  }

  double InertiaScheme::response_in_step(const double dt, const double frequency,
                                         const double damping) const
  {
    return beta * dt * dt /
           (mass_factor(dt, frequency) * (1. - alpha + gamma * dt * damping) +
            beta * dt * dt * frequency * frequency);
  }

  ModalState without_force(const InertiaScheme &scheme, const ModalState &begin, const double dt,
                           const double frequency, const double damping)
  {
    ModalState end{begin.displacement + dt * begin.velocity +
                       dt * dt * (0.5 - scheme.beta) * begin.acceleration,
                   begin.velocity + dt * (1. - scheme.gamma) * begin.acceleration, 0.};
    const Complex force = -scheme.mass_factor(dt, frequency) *
                              (scheme.alpha * begin.acceleration + damping * end.velocity) -
                          frequency * frequency * end.displacement;
    add_force(scheme, force, dt, frequency, damping, end);
    return end;
  }

  void add_force(const InertiaScheme &scheme, const Complex &force, const double dt,
                 const double frequency, const double damping, ModalState &end)
  {
    const Complex displacement = force * scheme.response_in_step(dt, frequency, damping),
                  acceleration = displacement / (scheme.beta * dt * dt);
    end.acceleration += acceleration;
    end.velocity += scheme.gamma * dt * acceleration;
    end.displacement += displacement;
  }
} // namespace ringmotor
