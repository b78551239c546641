// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/pictures/sector_field.h>

#include <array>
#include <cmath>
#include <complex>

namespace ringmotor::tests
{
  /**
   * A ring of rectangular cross-section (two materials, one on top of the other) with a known wave:
   * in cylindrical components the amplitude is profile(r, z) exp(-i n theta), which obeys the
   * sector rule U(theta + alpha) = exp(-i n alpha) R(alpha) U(theta) for every n and N, so the
   * motion of every point of the whole ring is known from its coordinates alone.
   */
  struct WaveRing
  {
    double inner_radius = 30e-3, outer_radius = 36e-3, height = 4e-3;
    double amplitude            = 2e-6;
    unsigned int n_cells_r      = 2;
    unsigned int n_cells_theta  = 2;
    unsigned int n_cells_z      = 2;
    unsigned int order          = 2;
    unsigned int n_sectors      = 12;
    unsigned int nodal_diameter = 5;
    double angular_frequency    = 2. * M_PI * 30e3;

    double exact_volume() const
    {
      return M_PI * (outer_radius * outer_radius - inner_radius * inner_radius) * height;
    }

    /** Radial, theta and axial amplitude at theta = 0: an axial bending wave with the rotation of
     * its cross-section (imaginary: a quarter of a period apart) and some twist. */
    std::array<std::complex<double>, 3> profile(const double radius, const double z) const
    {
      const std::complex<double> i(0., 1.);
      return {{-0.13 * amplitude * z / height,
               i * (amplitude * nodal_diameter * (z - height / 2.) / radius),
               amplitude * radius / outer_radius}};
    }

    /** Substitute for the strain energy density, J/m^3. */
    double energy(const double radius, const double z) const { return 1e3 * radius + 5e4 * z * z; }

    /** Cartesian displacement at a point of the ring at the phase omega t. */
    std::array<double, 3> motion(const std::array<double, 3> &place, const double time_angle) const
    {
      const double theta = std::atan2(place[1], place[0]);
      const auto values  = profile(std::hypot(place[0], place[1]), place[2]);
      const auto phase   = std::polar(1., time_angle - nodal_diameter * theta);
      const double u_r = std::real(values[0] * phase), u_theta = std::real(values[1] * phase);
      return {{u_r * std::cos(theta) - u_theta * std::sin(theta),
               u_r * std::sin(theta) + u_theta * std::cos(theta), std::real(values[2] * phase)}};
    }

    SectorField field() const
    {
      SectorField result;
      result.order             = order;
      result.n_sectors         = n_sectors;
      result.nodal_diameter    = nodal_diameter;
      result.angular_frequency = angular_frequency;
      for (unsigned int k = 0; k < n_cells_z; ++k)
        for (unsigned int j = 0; j < n_cells_theta; ++j)
          for (unsigned int i = 0; i < n_cells_r; ++i)
            result.cells.push_back(cell(i, j, k));
      return result;
    }

  private:
    SectorField::Cell cell(const unsigned int i, const unsigned int j, const unsigned int k) const
    {
      const double pitch = 2. * M_PI / n_sectors;
      SectorField::Cell result;
      result.material = k < n_cells_z / 2 ? 1 : 2;
      // r, theta, z are right-handed in this order
      for (unsigned int c = 0; c <= order; ++c)
        for (unsigned int b = 0; b <= order; ++b)
          for (unsigned int a = 0; a <= order; ++a)
          {
            const auto lattice =
                [this](const unsigned int index, const unsigned int sub, const unsigned int n_cells)
            { return (index + static_cast<double>(sub) / order) / n_cells; };
            const double radius =
                inner_radius + (outer_radius - inner_radius) * lattice(i, a, n_cells_r);
            const double theta = pitch * (lattice(j, b, n_cells_theta) - 0.5);
            const double z     = height * lattice(k, c, n_cells_z);
            result.points.emplace_back(radius * std::cos(theta), radius * std::sin(theta), z);

            const auto values = profile(radius, z);
            const auto phase  = std::polar(1., -(nodal_diameter * theta));
            result.displacement.push_back(
                {{phase * (values[0] * std::cos(theta) - values[1] * std::sin(theta)),
                  phase * (values[0] * std::sin(theta) + values[1] * std::cos(theta)),
                  phase * values[2]}});
            result.strain_energy.push_back(energy(radius, z));
          }
      return result;
    }
  };
} // namespace ringmotor::tests
