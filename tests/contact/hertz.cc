// SPDX-License-Identifier: LGPL-2.1-or-later

// Hertz's line contact with finite elements: a cylinder of radius R_c on a flat, both blocks of one
// layer of cells along the line, without lateral contraction (nu = 0), where plane stress and plane
// strain are one: E* = E/2, a^2 = 4 F' R_c / (pi E*), p_0 = 2 F'/(pi a), F' force per length. The
// blocks are 18 a wide and 9 a deep, which makes a 0.4 % smaller than on half-spaces: the pressure
// is compared with Hertz's for the half width that follows from the largest pressure on the finest
// mesh.
//
// Convergence with the cell width h is limited by the regularity of the solution, whose pressure
// ends like a square root: displacements converge in the energy norm as h (linear cells) and
// h^(3/2) (quadratic ones), read off the differences of energies, which have twice the order;
// pressures in L2 as h whatever the degree, and as h^(3/2) in their natural norm, H^(-1/2), here
// the elastic energy of their error. Errors vary with the position of the contact edge in its cell:
// they are means over meshes in which it lies at -1/3, 0 and 1/3 of a cell.

#include "support/elastic_contact.h"
#include "support/record.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  const Material metal{200e9, 0., 8000., 0.};

  constexpr double half_width = 1e-3;                ///< m, a
  constexpr double cylinder   = 100. * half_width;   ///< m, R_c
  constexpr double radius     = 2e4 * half_width;    ///< m, of the ring the blocks are cut out of
  constexpr double along      = half_width;          ///< m, length of the line
  constexpr double peak       = 0.25 * 200e9 / 100.; ///< Pa, p_0 = E* a / (2 R_c)

  std::vector<double> bisected(std::vector<double> lines, const unsigned int level)
  {
    for (unsigned int l = 0; l < level; ++l)
    {
      std::vector<double> finer{lines[0]};
      for (unsigned int i = 1; i < lines.size(); ++i)
        finer.insert(finer.end(), {0.5 * (lines[i - 1] + lines[i]), lines[i]});
      lines = finer;
    }
    return lines;
  }

  /** A zone of equal cells, surrounded by wider ones; in units of a. */
  BlockLines block_lines(const double zone, const unsigned int n_zone, const unsigned int level,
                         const double side)
  {
    std::vector<double> across;
    for (const double x : {-9., -5., -3.2, -2.3})
      across.push_back(x);
    for (unsigned int i = 0; i <= n_zone; ++i)
      across.push_back(zone * (2. * i / n_zone - 1.));
    for (const double x : {2.3, 3.2, 5., 9.})
      across.push_back(x);
    BlockLines lines{bisected(across, level),
                     {0., 0.5 * along / radius},
                     bisected({0., 0.5, 1., 2., 4., 9.}, level)};
    for (double &r : lines.r)
      r = radius + half_width * r;
    for (double &z : lines.z)
      z *= side * half_width;
    return lines;
  }

  struct Found
  {
    double energy   = 0.;                      ///< N m, elastic energy and work against the gap
    double touching = 0.;                      ///< in units of a, half width
    double largest  = 0.;                      ///< Pa
    double cell     = 0.;                      ///< in units of a, width where the bodies touch
    std::vector<double> place, area, pressure; ///< by node; in units of a, m^2, Pa
    dealii::FullMatrix<double> compliance;     ///< normal, m/N
  };

  /** @p phase: distance of the contact edge from a mesh line, in cells. */
  Found press(const unsigned int degree, const unsigned int level, const double phase)
  {
    const double n    = 2 << level;
    const double zone = 1.5 * n / (n - phase);
    const CondensedBlock lower(block_lines(zone, 6, level, -1.), metal, degree,
                               radius - zone * half_width, radius + zone * half_width),
        upper(block_lines(zone + 0.1, 5, level, 1.), metal, degree,
              radius - (zone + 0.1) * half_width, radius + (zone + 0.1) * half_width);
    ElasticContact contact(lower, upper, 0.5 * M_PI * half_width * peak * along);
    std::vector<double> place;
    for (unsigned int a = 0; a < contact.n_points(); ++a)
    {
      place.push_back(lower.surface().nodes[contact.coupling.nodes[a].tooth_node].place[0] -
                      radius);
      contact.free_motion[a][0] = place[a] * place[a] / (2. * cylinder);
    }
    const ContactSolution solution = contact.solve(0.);
    EXPECT_TRUE(solution.certificate.holds());
    Found found;
    found.cell = zone / (3 << level);
    found.compliance.reinit(contact.n_points(), contact.n_points());
    for (unsigned int a = 0; a < contact.n_points(); ++a)
    {
      const double force = solution.state.force[a][0];
      // Half of the elastic part of the gap, and all of the part without forces
      found.energy += 0.5 * force *
                      (solution.motion[a][0] - solution.state.rigid[0] + contact.free_motion[a][0]);
      found.place.push_back(place[a] / half_width);
      found.area.push_back(contact.coupling.nodes[a].area);
      found.pressure.push_back(force / found.area[a]);
      if (force > 0.)
        found.touching = std::max(found.touching, std::abs(found.place[a]));
      found.largest = std::max(found.largest, found.pressure[a]);
      for (unsigned int b = 0; b < contact.n_points(); ++b)
        found.compliance(a, b) = contact.compliance(3 * a, 3 * b);
    }
    return found;
  }

  /** Squared relative errors of the pressure against Hertz's for this half width (in units of a).
   */
  struct PressureError
  {
    double in_l2, by_energy;
  };

  PressureError pressure_error(const Found &found, const double width)
  {
    const unsigned int n = found.place.size();
    dealii::Vector<double> expected(n), error(n);
    double l2_of_error = 0., l2_of_expected = 0.;
    for (unsigned int a = 0; a < n; ++a)
    {
      const double x     = found.place[a] / width;
      const double hertz = peak / width * std::sqrt(std::max(0., 1. - x * x));
      expected[a]        = found.area[a] * hertz;
      error[a]           = found.area[a] * (found.pressure[a] - hertz);
      l2_of_expected += expected[a] * hertz;
      l2_of_error += error[a] * error[a] / found.area[a];
    }
    return {l2_of_error / l2_of_expected, found.compliance.matrix_norm_square(error) /
                                              found.compliance.matrix_norm_square(expected)};
  }

  class Hertz : public testing::TestWithParam<unsigned int>
  {
  };
} // namespace

TEST_P(Hertz, IsApproachedAsFastAsItsSmoothnessAllows)
{
  const unsigned int degree = GetParam(), n_levels = degree == 1 ? 4 : 3;
  const double width = peak / press(2, 2, 0.3).largest;
  std::vector<double> energy(n_levels, 0.), in_l2(n_levels, 0.), by_energy(n_levels, 0.);
  for (unsigned int level = 0; level < n_levels; ++level)
    for (const double phase : {-1. / 3., 0., 1. / 3.})
    {
      const Found found         = press(degree, level, phase);
      const PressureError error = pressure_error(found, width);
      const std::string at      = ", mesh " + std::to_string(level);
      record("relative error of the peak pressure" + at, found.largest / peak - 1.);
      record("error of the half width (cells)" + at, (found.touching - 1.) / found.cell);
      energy[level] += found.energy / 3.;
      in_l2[level] += error.in_l2 / 3.;
      by_energy[level] += error.by_energy / 3.;
      EXPECT_LT(std::abs(found.touching - 1.), found.cell);
      if (level > 0)
      {
        EXPECT_NEAR(found.largest / peak, 1., 0.02);
      }
    }
  const auto recorded = [&](const std::string &what, const double slope)
  {
    record("slopes, " + what, slope);
    return slope;
  };
  // Mean squares have twice the slope.
  for (unsigned int level = 1; level < n_levels; ++level)
  {
    EXPECT_GT(recorded("pressure in L2", 0.5 * std::log2(in_l2[level - 1] / in_l2[level])), 0.9);
    EXPECT_GT(
        recorded("pressure in H^(-1/2)", 0.5 * std::log2(by_energy[level - 1] / by_energy[level])),
        1.4);
  }
  for (unsigned int level = 2; level < n_levels; ++level)
    EXPECT_GT(recorded("energy norm", 0.5 * std::log2((energy[level - 1] - energy[level - 2]) /
                                                      (energy[level] - energy[level - 1]))),
              degree == 1 ? 0.9 : 1.4);
}

INSTANTIATE_TEST_SUITE_P(Degree, Hertz, testing::Values(1u, 2u));
