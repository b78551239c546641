// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/rigid_motions.h>

#include <complex>
#include <numeric>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** Number @p which of the rigid motions of nodal diameter k at a point; two for k = 0 and for k
     * = 1. */
    std::array<Complex, 3> rigid_displacement(const unsigned int k, const unsigned int which,
                                              const Point<3> &x)
    {
      const Complex i(0., 1.);
      if (k == 0)
        return which == 0 ? std::array<Complex, 3>{{0., 0., 1.}}
                          : std::array<Complex, 3>{{-i * x[1], i * x[0], 0.}};
      // Both turn with exp(-i theta): R(alpha) (1, -i) = exp(i alpha) (1, -i).
      return which == 0 ? std::array<Complex, 3>{{1., -i, 0.}}
                        : std::array<Complex, 3>{{-x[2], i * x[2], x[0] - i * x[1]}};
    }

    /** a^H M b with M b given; complex only where the unknowns are. */
    Complex product(const CyclicSector &sector, const std::vector<double> &a,
                    const std::vector<double> &mass_b)
    {
      const double real = std::inner_product(a.begin(), a.end(), mass_b.begin(), 0.);
      if (!sector.is_complex())
        return real;
      const auto half = static_cast<std::ptrdiff_t>(a.size() / 2);
      const double imaginary =
          std::inner_product(a.begin(), a.begin() + half, mass_b.begin() + half, 0.) -
          std::inner_product(a.begin() + half, a.end(), mass_b.begin(), 0.);
      return {real, imaginary};
    }

    /** a -= factor * b */
    void subtract(const CyclicSector &sector, std::vector<double> &a, const Complex factor,
                  const std::vector<double> &b)
    {
      const std::size_t half = a.size() / 2;
      for (std::size_t j = 0; j < a.size(); ++j)
      {
        a[j] -= factor.real() * b[j];
        if (sector.is_complex())
          a[j] -= j < half ? -factor.imag() * b[j + half] : factor.imag() * b[j - half];
      }
    }
  } // namespace

  std::vector<std::vector<double>> rigid_motions(const CyclicSector &sector, const unsigned int k)
  {
    std::vector<std::vector<double>> motions;
    std::vector<double> mass_times;
    for (unsigned int which = 0; k < 2 && which < 2; ++which)
    {
      std::vector<double> motion =
          sector.unknowns_of(k, [&](const Point<3> &x) { return rigid_displacement(k, which, x); });
      for (const auto &earlier : motions)
      {
        sector.multiply_mass(k, motion, mass_times);
        subtract(sector, motion, product(sector, earlier, mass_times), earlier);
      }
      sector.multiply_mass(k, motion, mass_times);
      const double norm = std::sqrt(product(sector, motion, mass_times).real());
      for (double &entry : motion)
        entry /= norm;
      motions.push_back(motion);
    }
    return motions;
  }

  double rigid_fraction(const CyclicSector &sector, const unsigned int k,
                        const std::vector<std::vector<double>> &rigid_motions,
                        const std::vector<double> &unknowns)
  {
    double fraction = 0.;
    std::vector<double> mass_times;
    for (const auto &motion : rigid_motions)
    {
      sector.multiply_mass(k, motion, mass_times);
      fraction += std::norm(product(sector, unknowns, mass_times));
    }
    return fraction;
  }
} // namespace ringmotor
