// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/ring_modes.h>
#include <ringmotor/structure/rank_factors.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** Multiplicity of a wave of real numbers: 2, or 1 if it is its own conjugate. */
    double multiplicity(const unsigned int m, const unsigned int n)
    {
      return m == 0 || 2 * m == n ? 1. : 2.;
    }
  } // namespace

  /** Modes in terms of a few shapes of a sector's nodes that span all of them. */
  class ModesByShapes
  {
  public:
    explicit ModesByShapes(const RingModes &modes)
    {
      std::vector<std::pair<unsigned int, const RingMode *>> all;
      for (unsigned int k = 0; k < modes.size(); ++k)
        for (const RingMode &mode : modes[k])
          all.emplace_back(k, &mode);
      const std::size_t n_rows = all.empty() ? 0 : 3 * all.front().second->motion.size();
      FullMatrix<double> motions(n_rows, 2 * all.size());
      for (std::size_t r = 0; r < all.size(); ++r)
        for (std::size_t i = 0; i < n_rows; ++i)
        {
          const RingMode &mode  = *all[r].second;
          const Complex part    = mode.motion[i / 3][i % 3] / mode.angular_frequency;
          motions(i, 2 * r)     = part.real();
          motions(i, 2 * r + 1) = part.imag();
        }
      constexpr double rounding = 1e-12;
      RankFactors factors(motions, rounding);
      shapes = std::move(factors.columns);
      by_diameter.resize(modes.size());
      for (std::size_t r = 0; r < all.size(); ++r)
      {
        Mode mode{all[r].second->angular_frequency, all[r].second->of_tooth, {}};
        for (unsigned int i = 0; i < shapes.n(); ++i)
          mode.shares.emplace_back(factors.weights(i, 2 * r), factors.weights(i, 2 * r + 1));
        by_diameter[all[r].first].push_back(std::move(mode));
      }
    }

    struct Mode
    {
      double frequency; ///< rad/s
      bool of_tooth;
      std::vector<Complex> shares; ///< of the shapes in motion / omega

      /** 1/s */
      double damping(const RingDynamics &dynamics) const
      {
        return of_tooth ? 0. : dynamics.loss_factor * frequency;
      }

      /** omega motion^H f / omega^2: the static motion of this mode times omega. */
      Complex static_motion(const std::vector<Complex> &force_on_shapes) const
      {
        Complex sum = 0.;
        for (std::size_t i = 0; i < shares.size(); ++i)
          sum += std::conj(shares[i]) * force_on_shapes[i];
        return sum;
      }

      bool has_inertia(const RingDynamics &dynamics) const
      {
        return of_tooth || !dynamics.is_hysteretic;
      }

      /** Motion in a wave relative to the static motion. */
      Complex amplification(const RingDynamics &dynamics, const HistoryWave &wave,
                            const double dt) const
      {
        if (!has_inertia(dynamics))
          return 1. / Complex(1., wave.direction * dynamics.loss_factor);
        return frequency * frequency *
               dynamics.scheme.response(wave.z, dt, frequency, damping(dynamics));
      }

      /** Adds @p factor motion motion^H / omega^2, by shapes, by rows. */
      void add(const Complex &factor, std::vector<Complex> &matrix) const
      {
        const std::size_t n = shares.size();
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t j = 0; j < n; ++j)
            matrix[i * n + j] += factor * shares[i] * std::conj(shares[j]);
      }
    };

    /** Forces on shapes due to those on the nodes of all sectors (or instants) j, as the amplitude
     * of exp(i m angle j). */
    std::vector<Complex> wave_on_shapes(const std::vector<PointVector> &forces,
                                        const unsigned int n_sectors, const unsigned int m) const
    {
      const unsigned int n_nodes = shapes.m() / 3;
      std::vector<Complex> wave(shapes.m()), result(shapes.n());
      for (unsigned int j = 0; j < n_sectors; ++j)
      {
        const Complex phase = std::polar(
            1. / n_sectors,
            -2. * numbers::PI * (static_cast<std::size_t>(m) * j % n_sectors) / n_sectors);
        for (unsigned int a = 0; a < n_nodes; ++a)
          if (const PointVector &force = forces[j * n_nodes + a]; force != PointVector())
            for (unsigned int c = 0; c < 3; ++c)
              wave[3 * a + c] += phase * force[c];
      }
      for (unsigned int row = 0; row < shapes.m(); ++row)
        if (wave[row] != 0.)
          for (unsigned int i = 0; i < shapes.n(); ++i)
            result[i] += shapes(row, i) * wave[row];
      return result;
    }

    /** Adds the motions of a wave exp(i m angle j), given the amplitudes of all modes with its
     * nodal diameter. */
    void add_motion(const unsigned int k, const std::vector<Complex> &amplitudes,
                    const bool conjugate, const unsigned int m, const unsigned int n_sectors,
                    std::vector<PointVector> &motion) const
    {
      const unsigned int n_nodes = shapes.m() / 3;
      std::vector<Complex> of_shapes(shapes.n()), of_nodes(shapes.m());
      for (unsigned int r = 0; r < amplitudes.size(); ++r)
        for (unsigned int i = 0; i < of_shapes.size(); ++i)
          of_shapes[i] += by_diameter[k][r].frequency * amplitudes[r] * by_diameter[k][r].shares[i];
      for (unsigned int row = 0; row < of_nodes.size(); ++row)
        for (unsigned int i = 0; i < of_shapes.size(); ++i)
          of_nodes[row] += shapes(row, i) * of_shapes[i];
      for (unsigned int j = 0; j < n_sectors; ++j)
      {
        const double angle =
            2. * numbers::PI * (static_cast<std::size_t>(m) * j % n_sectors) / n_sectors;
        const Complex phase = std::polar(multiplicity(m, n_sectors), conjugate ? -angle : angle);
        for (unsigned int row = 0; row < of_nodes.size(); ++row)
          motion[j * n_nodes + row / 3][row % 3] += (phase * of_nodes[row]).real();
      }
    }

    FullMatrix<double> shapes; ///< orthonormal columns, a row for each component of a node
    std::vector<std::vector<Mode>> by_diameter;
  };

  SteadyInertia::SteadyInertia(const RingModes &modes, const unsigned int n_waves,
                               const unsigned int n_sectors, const double period,
                               const unsigned int n_instants, const double dt,
                               const RingDynamics &dynamics)
      : modes(std::make_shared<const ModesByShapes>(modes)), n_waves(n_waves), n_sectors(n_sectors),
        n_instants(n_instants), angle(2. * numbers::PI * dt / period), dt(dt), dynamics(dynamics)
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
    const unsigned int n_shapes = modes->shapes.n();
    std::vector<std::vector<Complex>> waves(n_instants / 2 + 1,
                                            std::vector<Complex>(n_shapes * n_shapes));
    for (unsigned int m = 1; m < waves.size(); ++m)
    {
      const HistoryWave around = wave(m);
      for (const ModesByShapes::Mode &mode : modes->by_diameter[around.k])
        mode.add(mode.amplification(dynamics, around, dt) - 1., waves[m]);
      if (around.conjugate)
        for (Complex &entry : waves[m])
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
        amplitudes.push_back(
            mode.static_motion(force) / mode.frequency *
            (mode.amplification(dynamics, around, dt) - (mode.of_tooth ? 1. : 0.)));
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
                      moved  = (1. - 1. / around.z) * (motion - at_rest);
        power.taken += weight * (std::conj(middle) * moved).real() / dt;
        if (!mode.has_inertia(dynamics))
          power.damped_by_factor += weight / dt * std::abs(around.z.imag()) * std::norm(motion);
        else if (!mode.of_tooth)
          power.damped_by_factor += weight / mode.frequency * std::norm(velocity);
      }
    }
    return power;
  }

  MarchedModes::MarchedModes(const RingModes &modes, const unsigned int n_sectors,
                             const RingDynamics &dynamics)
      : modes(std::make_shared<const ModesByShapes>(modes)), n_sectors(n_sectors),
        dynamics(dynamics)
  {
    Assert(!dynamics.is_hysteretic, ExcMessage("hysteretic damping in single steps"));
  }

  MarchedModes::ByMode MarchedModes::modal_forces(const std::vector<PointVector> &forces) const
  {
    ByMode result(modes->by_diameter.size());
    for (unsigned int k = 0; k < result.size(); ++k)
      if (!modes->by_diameter[k].empty())
      {
        // Sector j of a wave has the phase -k j alpha.
        const std::vector<Complex> force =
            modes->wave_on_shapes(forces, n_sectors, (n_sectors - k) % n_sectors);
        for (const ModesByShapes::Mode &mode : modes->by_diameter[k])
          result[k].push_back(mode.frequency * mode.static_motion(force));
      }
    return result;
  }

  void MarchedModes::rest(const std::vector<PointVector> &forces)
  {
    earlier = modal_forces(forces);
    states.clear();
    for (unsigned int k = 0; k < earlier.size(); ++k)
    {
      states.emplace_back();
      for (unsigned int r = 0; r < earlier[k].size(); ++r)
        states[k].push_back(
            {earlier[k][r] / std::pow(modes->by_diameter[k][r].frequency, 2), 0., 0.});
    }
  }

  void MarchedModes::set(std::vector<std::vector<ModalState>> new_states,
                         const std::vector<PointVector> &forces)
  {
    states  = std::move(new_states);
    earlier = modal_forces(forces);
  }

  RingCompliance MarchedModes::compliance(const double dt) const
  {
    const unsigned int n_shapes = modes->shapes.n();
    std::vector<std::vector<Complex>> waves(n_sectors / 2 + 1,
                                            std::vector<Complex>(n_shapes * n_shapes));
    for (unsigned int k = 0; k < waves.size(); ++k)
    {
      for (const ModesByShapes::Mode &mode : modes->by_diameter[k])
        mode.add(std::pow(mode.frequency, 2) * dynamics.scheme.response_in_step(
                                                   dt, mode.frequency, mode.damping(dynamics)) -
                     1.,
                 waves[k]);
      for (Complex &entry : waves[k]) // the ring compliance's waves are exp(+i k j alpha)
        entry = std::conj(entry);
    }
    return RingCompliance(n_sectors, modes->shapes, waves);
  }

  std::vector<PointVector> MarchedModes::motion_of(const ByMode &displacements) const
  {
    std::vector<PointVector> motion(n_sectors * modes->shapes.m() / 3);
    for (unsigned int k = 0; k < displacements.size(); ++k)
      if (!displacements[k].empty()) // exp(-i k j alpha)
        modes->add_motion(k, displacements[k], true, k, n_sectors, motion);
    return motion;
  }

  std::vector<PointVector> MarchedModes::motion() const
  {
    ByMode displacements(states.size());
    for (unsigned int k = 0; k < states.size(); ++k)
      for (unsigned int r = 0; r < states[k].size(); ++r)
      {
        const ModesByShapes::Mode &mode = modes->by_diameter[k][r];
        displacements[k].push_back(states[k][r].displacement);
        if (mode.of_tooth)
          displacements[k].back() -= earlier[k][r] / std::pow(mode.frequency, 2);
      }
    return motion_of(displacements);
  }

  std::vector<PointVector> MarchedModes::free_motion(const double dt) const
  {
    ByMode displacements(states.size());
    for (unsigned int k = 0; k < states.size(); ++k)
      for (unsigned int r = 0; r < states[k].size(); ++r)
      {
        const ModesByShapes::Mode &mode = modes->by_diameter[k][r];
        displacements[k].push_back(
            without_force(dynamics.scheme, states[k][r], dt, mode.frequency, mode.damping(dynamics))
                .displacement);
      }
    return motion_of(displacements);
  }

  ModalPower MarchedModes::step(const std::vector<PointVector> &forces, const double dt)
  {
    const ByMode now = modal_forces(forces);
    ModalPower power;
    for (unsigned int k = 0; k < states.size(); ++k)
      for (unsigned int r = 0; r < states[k].size(); ++r)
      {
        const ModesByShapes::Mode &mode = modes->by_diameter[k][r];
        const double omega = mode.frequency, damping = mode.damping(dynamics),
                     weight   = n_sectors * multiplicity(k, n_sectors);
        const ModalState from = states[k][r];
        ModalState &state     = states[k][r];
        state                 = without_force(dynamics.scheme, from, dt, omega, damping);
        add_force(dynamics.scheme, now[k][r], dt, omega, damping, state);
        const Complex moved =
            state.displacement - from.displacement - (now[k][r] - earlier[k][r]) / (omega * omega);
        power.taken += weight / dt * (std::conj(0.5 * (now[k][r] + earlier[k][r])) * moved).real();
        if (!mode.of_tooth)
          power.damped_by_factor +=
              weight * omega * std::norm(0.5 * (state.velocity + from.velocity));
      }
    earlier = now;
    return power;
  }
} // namespace ringmotor
