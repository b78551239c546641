// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/modes_by_shapes.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;
  } // namespace

  RingMode interpolated(const RingMode &mode, const std::vector<SurfaceWeights> &weights)
  {
    RingMode interpolated = mode;
    interpolated.motion.assign(weights.size(), {});
    interpolated.of_body.clear();
    for (std::size_t a = 0; a < weights.size(); ++a)
      for (const auto &[node, weight] : weights[a])
        for (unsigned int c = 0; c < 3; ++c)
          interpolated.motion[a][c] += weight * mode.motion[node][c];
    return interpolated;
  }

  std::shared_ptr<const ModesByShapes> by_shapes(const RingModes &modes)
  {
    return std::make_shared<const ModesByShapes>(modes);
  }

  SteadyInertia::SteadyInertia(std::shared_ptr<const ModesByShapes> of_ring,
                               const unsigned int n_waves, const unsigned int n_sectors,
                               const double period, const unsigned int n_instants, const double dt,
                               const RingDynamics &dynamics)
      : modes(std::move(of_ring)), n_waves(n_waves), n_sectors(n_sectors), n_instants(n_instants),
        angle(2. * numbers::PI * dt / period), dt(dt), dynamics(dynamics)
  {
  }

  HistoryWave SteadyInertia::wave(const unsigned int m) const
  {
    const unsigned int around = static_cast<std::size_t>(n_waves) * m % n_sectors;
    const bool conjugate      = 2 * around > n_sectors;
    const double sign         = conjugate ? -1. : 1.;
    return {conjugate ? n_sectors - around : around, conjugate, std::polar(1., sign * m * angle),
            m == 0 || 2 * m == n_instants ? 0. : sign};
  }

  std::vector<Complex> SteadyInertia::on_shapes(const std::vector<PointVector> &forces,
                                                const unsigned int m) const
  {
    std::vector<Complex> of_wave = modes->wave_on_shapes(forces, n_instants, m);
    if (wave(m).conjugate)
      for (Complex &force : of_wave)
        force = std::conj(force);
    return of_wave;
  }

  RingCompliance SteadyInertia::compliance() const
  {
    std::vector<std::vector<Complex>> waves;
    for (unsigned int m = 0; 2 * m <= n_instants; ++m)
    {
      const HistoryWave around = wave(m);
      std::vector<Complex> factors;
      for (const ModesByShapes::Mode &mode : modes->by_diameter[around.k])
        factors.push_back(mode.amplification(dynamics, around, dt) - mode.at_once);
      waves.push_back(modes->sum_over_modes(around.k, factors));
      if (around.conjugate)
        for (Complex &entry : waves.back())
          entry = std::conj(entry);
    }
    return RingCompliance(n_instants, modes->shapes, waves);
  }

  std::vector<PointVector> SteadyInertia::motion(const std::vector<PointVector> &forces) const
  {
    std::vector<PointVector> motion(forces.size());
    for (unsigned int m = 0; 2 * m <= n_instants; ++m)
    {
      const HistoryWave around = wave(m);
      if (modes->by_diameter[around.k].empty())
        continue;
      const std::vector<Complex> force = on_shapes(forces, m);
      std::vector<Complex> amplitudes;
      for (const ModesByShapes::Mode &mode : modes->by_diameter[around.k])
        amplitudes.push_back(mode.static_motion(force) / mode.frequency *
                             (mode.amplification(dynamics, around, dt) - mode.of_teeth_at_once()));
      modes->add_motion(around.k, amplitudes, around.conjugate, m, n_instants, motion);
    }
    return motion;
  }

  std::vector<std::vector<ModalState>>
  SteadyInertia::states(const std::vector<PointVector> &forces) const
  {
    std::vector<std::vector<ModalState>> states;
    for (const auto &of_diameter : modes->by_diameter)
      states.emplace_back(of_diameter.size());
    for (unsigned int m = 0; 2 * m <= n_instants; ++m)
    {
      const HistoryWave around = wave(m);
      if (modes->by_diameter[around.k].empty())
        continue;
      const std::vector<Complex> force = on_shapes(forces, m);
      // Waves may be their own conjugates in time or around the ring.
      const double weight = multiplicity(m, n_instants) / multiplicity(around.k, n_sectors);
      for (unsigned int r = 0; r < states[around.k].size(); ++r)
      {
        const ModesByShapes::Mode &mode = modes->by_diameter[around.k][r];
        const Complex displacement      = weight / mode.frequency * mode.static_motion(force) *
                                     mode.amplification(dynamics, around, dt);
        ModalState &state = states[around.k][r];
        state.displacement += displacement;
        state.velocity += dynamics.scheme.velocity(around.z, dt) * displacement;
        state.acceleration += dynamics.scheme.acceleration(around.z, dt) * displacement;
      }
    }
    return states;
  }

  std::vector<Complex> SteadyInertia::vibration(const std::vector<PointVector> &forces,
                                                const unsigned int n_samples) const
  {
    std::vector<std::size_t> first(1, 0); // of the modes of each nodal diameter
    for (const auto &of_diameter : modes->by_diameter)
      first.push_back(first.back() + of_diameter.size());
    std::vector<Complex> amplitudes(n_samples * first.back());
    for (unsigned int m = 1; 2 * m <= n_instants; ++m)
    {
      const HistoryWave around = wave(m);
      const auto &of_diameter  = modes->by_diameter[around.k];
      if (of_diameter.empty())
        continue;
      const std::vector<Complex> force = on_shapes(forces, m);
      // As in states().
      const double weight = multiplicity(m, n_instants) / multiplicity(around.k, n_sectors);
      for (unsigned int r = 0; r < of_diameter.size(); ++r)
      {
        Complex amplitude = weight / of_diameter[r].frequency *
                            of_diameter[r].static_motion(force) *
                            (of_diameter[r].amplification(dynamics, around, dt) - 1.);
        for (unsigned int sample = 0; sample < n_samples; ++sample, amplitude *= around.z)
          amplitudes[sample * first.back() + first[around.k] + r] += amplitude;
      }
    }
    return amplitudes;
  }

  ModalPower SteadyInertia::power(const std::vector<PointVector> &forces) const
  {
    ModalPower power;
    for (unsigned int m = 1; 2 * m < n_instants; ++m) // the last one does no work in steps
    {
      const HistoryWave around = wave(m);
      if (modes->by_diameter[around.k].empty())
        continue;
      const std::vector<Complex> force = on_shapes(forces, m);
      const double weight              = n_sectors * multiplicity(m, n_instants);
      for (const ModesByShapes::Mode &mode : modes->by_diameter[around.k])
      {
        const Complex at_rest  = mode.static_motion(force), // times the frequency, like the next
            motion             = at_rest * mode.amplification(dynamics, around, dt),
                      velocity = motion * dynamics.scheme.velocity(around.z, dt);
        // Forces at the middle of steps and motions in the steps.
        const Complex middle = 0.5 * (1. + 1. / around.z) * at_rest,
                      moved  = (1. - 1. / around.z) * (motion - mode.at_once * at_rest);
        power.taken += weight * (std::conj(middle) * moved).real() / dt;
        const double damped_by_factor =
            mode.has_inertia(dynamics)
                ? weight / mode.frequency * std::norm(velocity)
                : weight / dt * std::abs(around.z.imag()) * std::norm(motion);
        if (mode.part == ModePart::rotor)
          power.damped_by_factor += damped_by_factor;
        else if (mode.part == ModePart::stator)
          power.lost_in_stator += mode.loss_factor(dynamics) * damped_by_factor;
      }
    }
    return power;
  }
} // namespace ringmotor
