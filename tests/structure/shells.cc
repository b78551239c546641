// SPDX-License-Identifier: LGPL-2.1-or-later

// Shell rings. Free annular plates against Kirchhoff's theory (Bessel functions,
// lambda^2 = omega a^2 sqrt(rho h / D), a the outer radius, nu = 0.3), down to a thickness of 1e-4
// of the radius. Half and whole sector give the same modes of an eccentric shell, whose waves
// couple stretching and bending; rigid motions are recognised.

#include "support/materials.h"
#include "support/record.h"
#include "support/ring_sector.h"
#include "support/same_modes.h"

#include <ringmotor/structure/modes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  /** lambda^2 of the lowest elastic mode of a free annular plate with outer radius 1 m. */
  double frequency_parameter(const double inner_radius, const double thickness,
                             const unsigned int n, const unsigned int degree,
                             const unsigned int n_radial)
  {
    const SectorMesh mesh =
        shell_ring(inner_radius, 1., {thickness, 0.}, n_radial, 24, SectorForm::half, 1);
    const CyclicSector sector(mesh, all_of(steel), degree);
    ModeSolver solver(sector);
    const double omega = std::sqrt(nearest_elastic(solver.lowest(n, 1), 1, 0.).front().eigenvalue);
    const double bending_stiffness = steel.young_modulus * std::pow(thickness, 3) /
                                     (12. * (1. - steel.poisson_ratio * steel.poisson_ratio));
    return omega * std::sqrt(steel.density * thickness / bending_stiffness);
  }

  const std::map<double, std::map<unsigned int, double>> kirchhoff{{0.5,
                                                                    {{0, 9.313481},
                                                                     {2, 4.271114},
                                                                     {3, 11.425440},
                                                                     {4, 21.067205},
                                                                     {5, 32.981542},
                                                                     {7, 63.272923},
                                                                     {9, 102.054515}}},
                                                                   {0.8,
                                                                    {{0, 18.472770},
                                                                     {2, 3.240978},
                                                                     {3, 8.984245},
                                                                     {4, 17.097113},
                                                                     {5, 27.560030},
                                                                     {7, 55.520500},
                                                                     {9, 92.818198}}}};
} // namespace

TEST(ShellRingsHard, ThinPlatesDoNotLock)
{
  for (const auto &[inner_radius, of_ring] : kirchhoff)
    for (const auto &[n, exact] : of_ring)
      for (const double thickness : {1e-3, 1e-4})
      {
        const double error = frequency_parameter(inner_radius, thickness, n, 4, 3) / exact - 1.;
        record("relative error, n = 0, 2, 3, 4, 5, 7, 9, b/a = 0." +
                   std::to_string(std::lround(10. * inner_radius)) + ", h/a = 1e" +
                   std::to_string(std::lround(std::log10(thickness))),
               error);
        EXPECT_NEAR(error, 0., 1e-3) << inner_radius << " " << n << " " << thickness;
      }
}

TEST(ShellRingsHard, ThinnerPlatesAreNoHarder)
{
  // Against a much finer mesh of the same plate. Boundary layers along its free edges, as wide as
  // the plate is thick, dominate the errors down to 1e-2, so their slopes depend on the thickness;
  // a shell that locks would get worse with every step.
  for (const unsigned int degree : {3u, 4u})
    for (const unsigned int n_radial : {1u, 2u, 4u})
    {
      const auto error = [&](const double thickness)
      {
        return frequency_parameter(0.5, thickness, 5, degree, n_radial) /
                   frequency_parameter(0.5, thickness, 5, 6, 8) -
               1.;
      };
      const double moderate = error(1e-2);
      for (const double thickness : {1e-3, 1e-4})
      {
        EXPECT_GT(error(thickness), 0.);
        EXPECT_LT(error(thickness), moderate) << degree << " " << n_radial << " " << thickness;
      }
    }
}

TEST(ShellRings, HalfAndWholeSectorHaveTheSameModes)
{
  const ShellSection eccentric{0.05, 0.02};
  const SectorMesh half  = shell_ring(0.6, 1., eccentric, 2, 11, SectorForm::half, 2),
                   whole = shell_ring(0.6, 1., eccentric, 2, 11, SectorForm::whole, 4);
  const CyclicSector half_sector(half, all_of(steel), 3), whole_sector(whole, all_of(steel), 3);
  expect_same_modes(half_sector, whole_sector, {0, 1, 2, 5}, 4);
}

TEST(ShellRings, OffsetOnlyMovesTheReferenceSurface)
{
  // The same plate, with its middle or its lower face as the reference surface.
  const SectorMesh middle = shell_ring(0.6, 1., {0.05, 0.}, 3, 11, SectorForm::half, 1),
                   lower  = shell_ring(0.6, 1., {0.05, 0.025}, 3, 11, SectorForm::half, 1);
  const CyclicSector middle_sector(middle, all_of(steel), 4), lower_sector(lower, all_of(steel), 4);
  ModeSolver middle_solver(middle_sector), lower_solver(lower_sector);
  for (const unsigned int k : {0u, 2u, 5u})
  {
    const std::vector<Mode> modes  = nearest_elastic(middle_solver.lowest(k, 3), 3, 0.),
                            others = nearest_elastic(lower_solver.lowest(k, 3), 3, 0.);
    for (unsigned int i = 0; i < 3; ++i)
      EXPECT_NEAR(modes[i].eigenvalue / others[i].eigenvalue, 1., 1e-5) << k << " " << i;
  }
}
