// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/motion_products.h>
#include <ringmotor/structure/rigid_motions.h>

#include <algorithm>
#include <cmath>
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
    NodeMotion rigid_motion(const unsigned int k, const unsigned int which, const Point<3> &x)
    {
      const Complex i(0., 1.);
      if (k == 0)
        return which == 0 ? NodeMotion{{{0., 0., 1.}}, {}}
                          : NodeMotion{{{-i * x[1], i * x[0], 0.}}, {{0., 0., i}}};
      // Both rotate with exp(-i theta): R(alpha) (1, -i) = exp(i alpha) (1, -i).
      return which == 0 ? NodeMotion{{{1., -i, 0.}}, {}}
                        : NodeMotion{{{-x[2], i * x[2], x[0] - i * x[1]}}, {{-i, -1., 0.}}};
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

  double slow_eigenvalue(const CyclicSector &sector)
  {
    double fastest = 0., radius = 0.;
    for (const auto &entry : sector.material_table())
      fastest = std::max(fastest, std::sqrt(entry.second.young_modulus / entry.second.density));
    for (unsigned int node = 0; node < sector.nodes().size(); ++node)
      radius = std::max(
          radius, std::hypot(sector.nodes().position(node)[0], sector.nodes().position(node)[1]));
    return std::pow(1e-3 * fastest / radius, 2);
  }

  namespace
  {
    /** The rigid motions of the free body, M-orthonormal. */
    std::vector<std::vector<double>> free_motions(const CyclicSector &sector, const unsigned int k)
    {
      std::vector<std::vector<double>> motions;
      std::vector<double> mass_times;
      for (unsigned int which = 0; which < 2; ++which)
      {
        std::vector<double> motion =
            sector.unknowns_of(k, [&](const Point<3> &x) { return rigid_motion(k, which, x); });
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

    std::vector<double> sum(const double factor_a, const std::vector<double> &a,
                            const double factor_b, const std::vector<double> &b)
    {
      std::vector<double> result(a.size());
      for (std::size_t i = 0; i < a.size(); ++i)
        result[i] = factor_a * a[i] + factor_b * b[i];
      return result;
    }
  } // namespace

  std::vector<std::vector<double>> rigid_motions(const CyclicSector &sector, const unsigned int k)
  {
    if (k > 1)
      return {};
    const auto stiffness = [&](const std::vector<double> &motion)
    {
      const SectorMotion expanded = sector.expand(k, motion);
      return motion_products(sector, {&expanded}).front().total_stiffness();
    };
    // Bars at one height constrain the shifts of a ring, but not its tilts about that height: find
    // the combinations of the two motions that nothing resists.
    const auto free    = free_motions(sector, k);
    const double first = stiffness(free[0]), second = stiffness(free[1]);
    const double mixed = 0.5 * (stiffness(sum(1., free[0], 1., free[1])) - first - second);
    const double angle = 0.5 * std::atan2(2. * mixed, first - second);
    std::vector<std::vector<double>> motions;
    for (const std::vector<double> &motion :
         {sum(std::cos(angle), free[0], std::sin(angle), free[1]),
          sum(-std::sin(angle), free[0], std::cos(angle), free[1])})
      if (stiffness(motion) < slow_eigenvalue(sector))
        motions.push_back(motion);
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
