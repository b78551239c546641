// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/wave/ring_content.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n_motions = CrossSections::n_motions;
    using OfMotions                  = std::array<double, n_motions>;

    /** Products of these motions with each other in the kinetic energy, at each quadrature point:
     * the lower triangle, row by row. */
    using Products = std::vector<std::array<double, n_motions *(n_motions + 1) / 2>>;

    Products products_of(const CrossSections &sections, const std::vector<MotionSample> &places)
    {
      Products products;
      for (const MotionSample &s : places)
      {
        const auto motions = sections.at(s);
        products.emplace_back();
        auto product = products.back().begin();
        for (unsigned int i = 0; i < n_motions; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            *product++ = s.mass * (motions[i][0] * motions[j][0] + motions[i][1] * motions[j][1] +
                                   motions[i][2] * motions[j][2]);
      }
      return products;
    }

    /** The same with the motion of a mode. */
    std::vector<OfMotions> products_with(const CrossSections &sections,
                                         const std::vector<MotionSample> &samples)
    {
      std::vector<OfMotions> products;
      for (const MotionSample &s : samples)
      {
        const auto motions = sections.at(s);
        products.emplace_back();
        for (unsigned int i = 0; i < n_motions; ++i)
          for (unsigned int d = 0; d < 3; ++d)
            products.back()[i] += s.mass * motions[i][d] * s.motion[d].real();
      }
      return products;
    }

    /** The one whose antinode is that of the wave. */
    unsigned int shown_motion(const Family family)
    {
      return family == Family::out_of_plane ? 0 : family == Family::torsion ? 5 : 2;
    }

    /** exp(i n theta) at each quadrature point. */
    using Phases = std::vector<std::complex<double>>;

    /** These motions times cos(n theta) and, unless n = 0, sin(n theta). */
    class StandingWaves
    {
    public:
      StandingWaves(const unsigned int n, const Products &of_sections, const Phases &phases)
          : n(n), n_phases(n > 0 ? 2 : 1), lower(n_phases * n_motions, n_phases * n_motions)
      {
        FullMatrix<double> products(lower.m(), lower.m());
        for (std::size_t s = 0; s < phases.size(); ++s)
        {
          const std::array<double, 2> phase{{phases[s].real(), phases[s].imag()}};
          auto product = of_sections[s].begin();
          for (unsigned int i = 0; i < n_motions; ++i)
            for (unsigned int j = 0; j <= i; ++j, ++product)
              for (unsigned int p = 0; p < n_phases; ++p)
                for (unsigned int q = 0; q < n_phases; ++q)
                  products(n_phases * i + p, n_phases * j + q) += phase[p] * phase[q] * *product;
        }
        for (unsigned int i = 0; i < lower.m(); ++i)
          for (unsigned int j = 0; j < i; ++j)
            products(j, i) = products(i, j);
        lower.cholesky(products);
      }

      /** @param products of the motions and a mode, whose energy is @p energy */
      RingContent content(const std::vector<OfMotions> &products, const Phases &phases,
                          const double energy) const
      {
        Vector<double> amplitudes(lower.m()), orthonormal(lower.m());
        for (std::size_t s = 0; s < phases.size(); ++s)
          for (unsigned int i = 0; i < n_motions; ++i)
          {
            amplitudes[n_phases * i] += phases[s].real() * products[s][i];
            if (n_phases == 2)
              amplitudes[2 * i + 1] += phases[s].imag() * products[s][i];
          }
        lower.forward(orthonormal, amplitudes);
        OfMotions share{};
        for (unsigned int i = 0; i < lower.m(); ++i)
          share[i / n_phases] += std::pow(orthonormal[i], 2) / energy;

        RingContent found;
        found.n_waves = n;
        found.content = content_of(share);
        found.share   = std::accumulate(share.begin(), share.end(), 0.);
        if (n > 0)
        {
          const unsigned int shown = shown_motion(found.content.family());
          const double angle       = std::atan2(orthonormal[2 * shown + 1], orthonormal[2 * shown]);
          found.antinode           = (angle < 0. ? angle + numbers::PI : angle) / n;
        }
        return found;
      }

    private:
      const unsigned int n, n_phases;
      FullMatrix<double> lower; ///< Cholesky factor of their products
    };
  } // namespace

  std::vector<RingContent> ring_contents(const CyclicSector &ring, std::vector<Mode> modes,
                                         const unsigned int most_waves)
  {
    std::vector<RingContent> best(modes.size());
    if (modes.empty())
      return best;
    for (Mode &mode : modes)
      mode.nodal_diameter = 0; // no phase is removed
    const std::vector<MotionSample> places = motion_samples(ring, modes.front());
    const CrossSections sections(places);
    const Products of_sections = products_of(sections, places);
    std::vector<std::vector<OfMotions>> products;
    std::vector<double> energies;
    for (const Mode &mode : modes)
    {
      const std::vector<MotionSample> samples =
          products.empty() ? places : motion_samples(ring, mode);
      products.push_back(products_with(sections, samples));
      energies.push_back(energy_of(samples));
    }
    Phases phases(places.size(), 1.);
    for (unsigned int n = 0; n <= most_waves; ++n)
    {
      const StandingWaves waves(n, of_sections, phases);
      for (std::size_t i = 0; i < modes.size(); ++i)
        if (const RingContent content = waves.content(products[i], phases, energies[i]);
            content.share > best[i].share)
          best[i] = content;
      for (std::size_t s = 0; s < places.size(); ++s)
        phases[s] *= std::polar(1., places[s].theta);
    }
    for (std::size_t i = 0; i < modes.size(); ++i)
    {
      modes[i].nodal_diameter       = best[i].n_waves;
      best[i].content.nodal_circles = count_nodal_circles(motion_samples(ring, modes[i]));
    }
    return best;
  }
} // namespace ringmotor
