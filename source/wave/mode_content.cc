// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/mirror.h>
#include <ringmotor/structure/shell_trace.h>
#include <ringmotor/wave/mode_content.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/fe_values_extractors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** Motion at a quadrature point, for a nodal diameter with the wave's phase removed: nearly
     * constant around the ring. */
    struct Sample
    {
      double r, theta, z, mass;
      std::array<Complex, 3> motion; ///< r, theta, z components times exp(i k theta)
    };

    /** @p u in Cartesian components. */
    Sample sample_at(const Point<3> &x, const double mass, const std::array<Complex, 3> &u,
                     const unsigned int nodal_diameter)
    {
      const double r      = std::hypot(x[0], x[1]);
      const double cosine = x[0] / r, sine = x[1] / r;
      const double theta  = std::atan2(x[1], x[0]);
      const Complex phase = std::polar(1., nodal_diameter * theta);
      return {r,
              theta,
              x[2],
              mass,
              {{phase * (cosine * u[0] + sine * u[1]), phase * (cosine * u[1] - sine * u[0]),
                phase * u[2]}}};
    }

    void sample_solids(const CyclicSector &sector, const Mode &mode, std::vector<Sample> &samples)
    {
      const FiniteElement<3> &fe = sector.dofs().get_fe();
      const QGauss<3> points(fe.degree + 1);
      FEValues<3> values(sector.geometry(), fe, points,
                         update_values | update_quadrature_points | update_JxW_values);
      const FEValuesExtractors::Vector displacement(0);
      std::vector<Tensor<1, 3>> real(points.size()), imaginary(points.size());
      for (const auto &cell : sector.dofs().active_cell_iterators())
      {
        values.reinit(cell);
        values[displacement].get_function_values(mode.motion.solid.real, real);
        values[displacement].get_function_values(mode.motion.solid.imaginary, imaginary);
        const double density = sector.material_table().at(cell->material_id()).density;
        for (unsigned int q = 0; q < points.size(); ++q)
          samples.push_back(sample_at(values.quadrature_point(q), density * values.JxW(q),
                                      {{{real[q][0], imaginary[q][0]},
                                        {real[q][1], imaginary[q][1]},
                                        {real[q][2], imaginary[q][2]}}},
                                      mode.nodal_diameter));
      }
    }

    /** The mass of shells moves with their mid-surface. */
    void sample_shells(const CyclicSector &sector, const Mode &mode, std::vector<Sample> &samples)
    {
      ShellTrace trace(sector, QGauss<2>(sector.shell_dofs().get_fe().degree + 1));
      for (const auto &cell : sector.shell_dofs().active_cell_iterators())
      {
        trace.reinit(cell, mode.motion.shell);
        const ShellSection &section = sector.sector_mesh().sections.at(cell->material_id());
        const double mass =
            sector.material_table().at(cell->material_id()).density * section.thickness;
        for (unsigned int q = 0; q < trace.size(); ++q)
          samples.push_back(sample_at(trace.position(q, section.offset), mass * trace.area(q),
                                      trace.displacement(q, section.offset), mode.nodal_diameter));
      }
    }

    std::vector<Sample> sample(const CyclicSector &sector, const Mode &mode)
    {
      std::vector<Sample> samples;
      if (sector.dofs().has_active_dofs())
        sample_solids(sector, mode, samples);
      if (sector.shell_dofs().has_active_dofs())
        sample_shells(sector, mode, samples);
      if (sector.sector_mesh().form == SectorForm::half)
      {
        const std::size_t n_half = samples.size();
        for (std::size_t i = 0; i < n_half; ++i)
        {
          Sample image = samples[i];
          image.motion = mirrored(image.motion);
          samples.push_back(image);
        }
      }
      return samples;
    }

    /** Sign changes, along the radius, of the axial motion that is in phase with its largest value.
     */
    unsigned int count_nodal_circles(const std::vector<Sample> &samples)
    {
      const auto [least, most] =
          std::minmax_element(samples.begin(), samples.end(),
                              [](const Sample &a, const Sample &b) { return a.r < b.r; });
      constexpr unsigned int n_bins = 24;
      std::array<Complex, n_bins> mean{};
      std::array<double, n_bins> mass{};
      for (const Sample &s : samples)
      {
        const auto bin = std::min(n_bins - 1, static_cast<unsigned int>(n_bins * (s.r - least->r) /
                                                                        (most->r - least->r)));
        mean[bin] += s.mass * s.motion[2];
        mass[bin] += s.mass;
      }
      Complex largest = 0.;
      for (unsigned int bin = 0; bin < n_bins; ++bin)
        if (mass[bin] > 0. && std::abs(mean[bin] /= mass[bin]) > std::abs(largest))
          largest = mean[bin];

      unsigned int changes = 0;
      double last          = 0.;
      for (unsigned int bin = 0; bin < n_bins; ++bin)
      {
        const double in_phase = std::real(mean[bin] * std::conj(largest));
        if (mass[bin] == 0. || std::abs(in_phase) < 0.02 * std::norm(largest))
          continue;
        changes += last * in_phase < 0.;
        last = in_phase;
      }
      return changes;
    }
  } // namespace

  std::string to_string(const Family family)
  {
    switch (family)
    {
    case Family::out_of_plane:
      return "out-of-plane";
    case Family::in_plane:
      return "in-plane";
    case Family::torsion:
      return "torsion";
    case Family::cross_section:
      return "cross-section";
    }
    Assert(false, ExcInternalError());
    return "";
  }

  Family ModeContent::family() const
  {
    const std::array<double, 4> fractions{{axial, in_plane, torsion, cross_section}};
    return static_cast<Family>(std::max_element(fractions.begin(), fractions.end()) -
                               fractions.begin());
  }

  namespace
  {
    constexpr unsigned int n_motions = 6;

    /**
     * Rigid motions of the cross-section in (r, theta, z): axial shift and its tilt; radial and
     * tangential shift and the rotation about the axis; torsion. They are orthonormalised in this
     * order.
     */
    class CrossSectionMotions
    {
    public:
      explicit CrossSectionMotions(const std::vector<Sample> &samples);

      /** Their amplitudes, times the root of the mass, in a motion. */
      std::array<Complex, n_motions> amplitudes(const std::vector<Sample> &samples) const;

      /** Twice the kinetic energy at unit frequency. */
      double energy() const { return all; }

    private:
      std::array<std::array<double, 3>, n_motions> at(const Sample &sample) const
      {
        const double r = sample.r - center_r, z = sample.z - center_z;
        return {{{{0, 0, 1}}, {{0, z, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, r, 0}}, {{z, 0, -r}}}};
      }

      double center_r = 0., center_z = 0., all = 0.;
      FullMatrix<double> lower; ///< Cholesky factor of their products
    };

    CrossSectionMotions::CrossSectionMotions(const std::vector<Sample> &samples)
        : lower(n_motions, n_motions)
    {
      double mass = 0.;
      for (const Sample &s : samples)
      {
        mass += s.mass;
        center_r += s.mass * s.r;
        center_z += s.mass * s.z;
        all += s.mass * (std::norm(s.motion[0]) + std::norm(s.motion[1]) + std::norm(s.motion[2]));
      }
      center_r /= mass;
      center_z /= mass;
      FullMatrix<double> gram(n_motions, n_motions);
      for (const Sample &s : samples)
      {
        const auto motions = at(s);
        for (unsigned int i = 0; i < n_motions; ++i)
          for (unsigned int j = 0; j < n_motions; ++j)
            for (unsigned int d = 0; d < 3; ++d)
              gram(i, j) += s.mass * motions[i][d] * motions[j][d];
      }
      lower.cholesky(gram);
    }

    std::array<Complex, n_motions>
    CrossSectionMotions::amplitudes(const std::vector<Sample> &samples) const
    {
      std::array<Complex, n_motions> overlap{};
      for (const Sample &s : samples)
      {
        const auto motions = at(s);
        for (unsigned int i = 0; i < n_motions; ++i)
          for (unsigned int d = 0; d < 3; ++d)
            overlap[i] += s.mass * motions[i][d] * s.motion[d];
      }
      for (unsigned int i = 0; i < n_motions; ++i)
      {
        for (unsigned int j = 0; j < i; ++j)
          overlap[i] -= lower(i, j) * overlap[j];
        overlap[i] /= lower(i, i);
      }
      return overlap;
    }

    /** @param energy of which @p amplitudes are parts */
    ModeContent content_of(const std::array<Complex, n_motions> &amplitudes, const double energy)
    {
      const auto fraction = [&](const unsigned int i) { return std::norm(amplitudes[i]) / energy; };
      ModeContent content;
      content.axial         = fraction(0) + fraction(1);
      content.in_plane      = fraction(2) + fraction(3) + fraction(4);
      content.torsion       = fraction(5);
      content.cross_section = std::max(0., 1. - content.axial - content.in_plane - content.torsion);
      return content;
    }
  } // namespace

  ModeContent mode_content(const CyclicSector &sector, const Mode &mode)
  {
    const std::vector<Sample> samples = sample(sector, mode);
    const CrossSectionMotions motions(samples);
    ModeContent content   = content_of(motions.amplitudes(samples), motions.energy());
    content.nodal_circles = count_nodal_circles(samples);
    return content;
  }

  RingContent ring_content(const CyclicSector &ring, const Mode &mode,
                           const unsigned int most_waves)
  {
    Mode as_it_is             = mode;
    as_it_is.nodal_diameter   = 0;
    std::vector<Sample> waves = sample(ring, as_it_is);
    std::vector<Complex> turn; // by which one more wave turns each sample
    for (const Sample &s : waves)
      turn.push_back(std::polar(1., s.theta));
    const CrossSectionMotions motions(waves);
    RingContent found;
    for (unsigned int n = 0; n <= most_waves; ++n)
    {
      // A standing wave is the sum of two that travel, each with half of its energy.
      const auto amplitudes     = motions.amplitudes(waves);
      const ModeContent content = content_of(amplitudes, motions.energy() * (n > 0 ? 0.5 : 1.));
      if (const double share = content.axial + content.in_plane + content.torsion;
          share > found.share)
      {
        const Complex largest       = *std::max_element(amplitudes.begin(), amplitudes.end(),
                                                        [](const Complex &a, const Complex &b)
                                                        { return std::norm(a) < std::norm(b); });
        found.n_waves               = n;
        found.share                 = share;
        found.content               = content;
        found.content.nodal_circles = count_nodal_circles(waves);
        found.antinode              = n > 0 ? std::arg(largest) / n : 0.;
        if (n > 0 && found.antinode < 0.)
          found.antinode += numbers::PI / n;
      }
      for (std::size_t i = 0; i < waves.size(); ++i)
        for (Complex &component : waves[i].motion)
          component *= turn[i];
    }
    return found;
  }
} // namespace ringmotor
