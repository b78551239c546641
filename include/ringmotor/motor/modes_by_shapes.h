// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/blas.h>
#include <ringmotor/algebra/rank_factors.h>
#include <ringmotor/motor/ring_modes.h>

#include <cmath>

// Internal to the source files of SteadyInertia and MarchedModes.

namespace ringmotor
{
  /** Multiplicity of a wave of real numbers: 2, or 1 if it is its own conjugate. */
  inline double multiplicity(const unsigned int m, const unsigned int n)
  {
    return m == 0 || 2 * m == n ? 1. : 2.;
  }

  /** Modes in terms of a few shapes of a sector's nodes that span all of them. */
  class ModesByShapes
  {
  public:
    using Complex = std::complex<double>;

    explicit ModesByShapes(const RingModes &modes)
    {
      std::vector<std::pair<unsigned int, const RingMode *>> all;
      for (unsigned int k = 0; k < modes.size(); ++k)
        for (const RingMode &mode : modes[k])
          all.emplace_back(k, &mode);
      const std::size_t n_rows = all.empty() ? 0 : 3 * all.front().second->motion.size();
      dealii::FullMatrix<double> motions(n_rows, 2 * all.size());
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
        const RingMode &of = *all[r].second;
        Mode mode{of.angular_frequency, of.part, of.response, of.loss_factor, of.at_once(), {}};
        for (unsigned int i = 0; i < shapes.n(); ++i)
          mode.shares.emplace_back(factors.weights(i, 2 * r), factors.weights(i, 2 * r + 1));
        by_diameter[all[r].first].push_back(std::move(mode));
      }
    }

    struct Mode
    {
      double frequency; ///< rad/s
      ModePart part;
      ModeResponse response;
      double own_loss_factor;
      double at_once;              ///< see RingMode
      std::vector<Complex> shares; ///< of the shapes in motion / omega

      double loss_factor(const RingDynamics &dynamics) const
      {
        return own_loss_factor + dynamics.added_loss_factor +
               (part == ModePart::rotor ? dynamics.loss_factor : 0.);
      }

      /** 1/s */
      double damping(const RingDynamics &dynamics) const
      {
        return loss_factor(dynamics) * frequency;
      }

      /** The same share of what SteadyInertia::motion() leaves to the static motion. */
      double of_teeth_at_once() const { return part == ModePart::tooth ? 1. : 0.; }

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
        return dynamics.gives_inertia_to(part, response);
      }

      /** Motion in a wave relative to the static motion. */
      Complex amplification(const RingDynamics &dynamics, const HistoryWave &wave,
                            const double dt) const
      {
        return at_once + dynamics.share * (whole_amplification(dynamics, wave, dt) - at_once);
      }

      Complex whole_amplification(const RingDynamics &dynamics, const HistoryWave &wave,
                                  const double dt) const
      {
        if (response != ModeResponse::vibrates)
          return response == ModeResponse::none ? 0. : 1.;
        if (!has_inertia(dynamics))
          return 1. / Complex(1., wave.direction * loss_factor(dynamics));
        return frequency * frequency *
               dynamics.scheme.response(wave.z, dt, frequency, damping(dynamics));
      }
    };

    /** The sum of factor motion motion^H / omega^2 over the modes of nodal diameter @p k, by
     * shapes, by rows. @param factors of each mode */
    std::vector<Complex> sum_over_modes(const unsigned int k,
                                        const std::vector<Complex> &factors) const
    {
      const int n = shapes.n(), n_modes = factors.size();
      std::vector<Complex> sum(static_cast<std::size_t>(n) * n), scaled, conjugate;
      if (sum.empty() || factors.empty())
        return sum;
      for (int r = 0; r < n_modes; ++r)
        for (const Complex &share : by_diameter[k][r].shares)
        {
          scaled.push_back(factors[r] * share);
          conjugate.push_back(std::conj(share));
        }
      const Complex one(1.), zero;
      zgemm_("N", "T", &n, &n, &n_modes, &one, conjugate.data(), &n, scaled.data(), &n, &zero,
             sum.data(), &n);
      return sum;
    }

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
            -2. * dealii::numbers::PI * (static_cast<std::size_t>(m) * j % n_sectors) / n_sectors);
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
            2. * dealii::numbers::PI * (static_cast<std::size_t>(m) * j % n_sectors) / n_sectors;
        const Complex phase = std::polar(multiplicity(m, n_sectors), conjugate ? -angle : angle);
        for (unsigned int row = 0; row < of_nodes.size(); ++row)
          motion[j * n_nodes + row / 3][row % 3] += (phase * of_nodes[row]).real();
      }
    }

    dealii::FullMatrix<double> shapes; ///< orthonormal columns, a row for each component of a node
    std::vector<std::vector<Mode>> by_diameter;
  };
} // namespace ringmotor
