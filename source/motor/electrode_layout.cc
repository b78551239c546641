// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/motor/electrode_layout.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/parameters/short_text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ringmotor
{
  namespace
  {
    constexpr double pi = dealii::numbers::PI;

    /** Arcs of a length with gaps between them, all angles in rad, poled up and down in turn. */
    std::vector<ElectrodeLayout::Arc> row_of_arcs(const unsigned int n_arcs, const double begin,
                                                  const double length, const double gap)
    {
      std::vector<ElectrodeLayout::Arc> arcs;
      for (unsigned int i = 0; i < n_arcs; ++i)
        arcs.push_back({begin + i * length + 0.5 * gap, begin + (i + 1) * length - 0.5 * gap,
                        i % 2 == 0 ? 1. : -1.});
      return arcs;
    }
  } // namespace

  double mean_radius_of_ceramic(const Parameters &parameters)
  {
    const RadialRange radii = stator_shape(parameters)->radii_of(ids::piezoceramic);
    if (radii.is_empty())
      throw UserError("Effects/Piezoelectric coupling needs a ceramic, but " +
                      parameters.stator.file_entry() +
                      " has no part 'piezoceramic'; allowed: off, or a file with it");
    return 0.5 * (radii.inner + radii.outer);
  }

  ElectrodeLayout::ElectrodeLayout(const Electrodes &electrodes, const Motor &motor,
                                   const double radius)
      : gap(electrodes.arc_gap / radius)
  {
    const unsigned int usual = motor.n_waves > 1 ? motor.n_waves - 1 : 1,
                       n_a   = electrodes.n_arcs_a.value_or(usual),
                       n_b   = electrodes.n_arcs_b.value_or(usual);
    const double waves       = 0.5 * (n_a + n_b) + electrodes.phase_distance;
    if (waves > motor.n_waves)
      throw UserError("Electrodes/Arcs of phase A = " + std::to_string(n_a) +
                      " and Arcs of phase B = " + std::to_string(n_b) +
                      " of half a wave each, with Distance of phases = " +
                      short_text(electrodes.phase_distance) + ", need " + short_text(waves) +
                      " waves, but Motor/Number of waves = " + std::to_string(motor.n_waves) +
                      "; allowed: arcs that fit on the ring; use fewer arcs, or \"usual\"");
    const double arc = pi / motor.n_waves;
    if (gap >= arc)
      throw UserError("Electrodes/Gap between arcs = " + short_text(electrodes.arc_gap) +
                      " m is not smaller than half a wave of the motor; allowed: less than " +
                      short_text(electrodes.arc_gap * arc / gap) + " m");
    arcs_of[0] = row_of_arcs(n_a, 0., arc, gap);
    arcs_of[1] = row_of_arcs(n_b, (n_a + 2. * electrodes.phase_distance) * arc, arc, gap);
  }

  double ElectrodeLayout::coverage(const Phase phase) const
  {
    double angle = 0.;
    for (const Arc &arc : arcs(phase))
      angle += arc.end - arc.begin;
    return angle / (2. * pi);
  }

  std::vector<ElectrodeLayout::Corner> ElectrodeLayout::corners(const Phase phase) const
  {
    const std::vector<Arc> &row = arcs(phase);
    std::vector<Corner> corners{{row.front().begin - gap, 0.}};
    for (const Arc &arc : row)
    {
      corners.push_back({arc.begin, arc.sign});
      corners.push_back({arc.end, arc.sign});
    }
    corners.push_back({row.back().end + gap, 0.});
    return corners;
  }

  std::complex<double> ElectrodeLayout::harmonic(const Phase phase, const int k) const
  {
    const std::vector<Corner> line = corners(phase);
    std::complex<double> sum       = 0.;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      // The integral of a linear function times exp(-i k theta) over one piece, about its middle;
      // sin(x)/x and its derivative for short pieces too
      const double half   = 0.5 * (line[i + 1].angle - line[i].angle),
                   middle = 0.5 * (line[i + 1].angle + line[i].angle),
                   mean   = 0.5 * (line[i + 1].potential + line[i].potential),
                   rise = 0.5 * (line[i + 1].potential - line[i].potential), x = k * half;
      const double even = std::abs(x) < 1e-3 ? 1. - x * x / 6. : std::sin(x) / x,
                   odd  = std::abs(x) < 1e-3 ? x / 3. : (std::sin(x) / x - std::cos(x)) / x;
      sum +=
          2. * half * std::polar(1., -k * middle) * std::complex<double>(mean * even, -rise * odd);
    }
    return sum / (2. * pi);
  }

  double ElectrodeLayout::standing_part(const unsigned int n) const
  {
    const int k = static_cast<int>(n);
    return std::abs(std::cos(std::arg(harmonic(Phase::b, k) / harmonic(Phase::a, k))));
  }

  double ElectrodeLayout::mean_square(const Phase phase) const
  {
    const std::vector<Corner> line = corners(phase);
    double sum                     = 0.;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      const double a = line[i].potential, b = line[i + 1].potential;
      sum += (line[i + 1].angle - line[i].angle) * (a * a + a * b + b * b) / 3.;
    }
    return sum / (2. * pi);
  }
} // namespace ringmotor
