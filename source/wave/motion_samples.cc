// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/mirror.h>
#include <ringmotor/structure/shell_trace.h>
#include <ringmotor/wave/motion_samples.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/fe_values_extractors.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** @p u in Cartesian components. */
    MotionSample sample_at(const Point<3> &x, const double mass, const std::array<Complex, 3> &u,
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

    void sample_solids(const CyclicSector &sector, const Mode &mode,
                       std::vector<MotionSample> &samples)
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
    void sample_shells(const CyclicSector &sector, const Mode &mode,
                       std::vector<MotionSample> &samples)
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
  } // namespace

  std::vector<MotionSample> motion_samples(const CyclicSector &sector, const Mode &mode)
  {
    std::vector<MotionSample> samples;
    if (sector.dofs().has_active_dofs())
      sample_solids(sector, mode, samples);
    if (sector.shell_dofs().has_active_dofs())
      sample_shells(sector, mode, samples);
    if (sector.sector_mesh().form == SectorForm::half)
    {
      const std::size_t n_half = samples.size();
      for (std::size_t i = 0; i < n_half; ++i)
      {
        MotionSample image = samples[i];
        image.motion       = mirrored(image.motion);
        samples.push_back(image);
      }
    }
    return samples;
  }

  double energy_of(const std::vector<MotionSample> &samples)
  {
    double energy = 0.;
    for (const MotionSample &s : samples)
      energy += s.mass * (std::norm(s.motion[0]) + std::norm(s.motion[1]) + std::norm(s.motion[2]));
    return energy;
  }

  CrossSections::CrossSections(const std::vector<MotionSample> &samples)
  {
    double mass = 0.;
    for (const MotionSample &s : samples)
    {
      mass += s.mass;
      center_r += s.mass * s.r;
      center_z += s.mass * s.z;
    }
    center_r /= mass;
    center_z /= mass;
  }

  std::array<std::array<double, 3>, CrossSections::n_motions>
  CrossSections::at(const MotionSample &sample) const
  {
    const double r = sample.r - center_r, z = sample.z - center_z;
    return {{{{0, 0, 1}}, {{0, z, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, r, 0}}, {{z, 0, -r}}}};
  }

  unsigned int count_nodal_circles(const std::vector<MotionSample> &samples)
  {
    const auto [least, most] =
        std::minmax_element(samples.begin(), samples.end(),
                            [](const MotionSample &a, const MotionSample &b) { return a.r < b.r; });
    constexpr unsigned int n_bins = 24;
    std::array<Complex, n_bins> mean{};
    std::array<double, n_bins> mass{};
    for (const MotionSample &s : samples)
    {
      const auto bin = std::min(
          n_bins - 1, static_cast<unsigned int>(n_bins * (s.r - least->r) / (most->r - least->r)));
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
} // namespace ringmotor
