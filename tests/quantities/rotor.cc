// SPDX-License-Identifier: LGPL-2.1-or-later

// Modes of the rotor: rigid motions of a rotor without bars are recognised, half and whole sector
// agree, error bars hold what a far better mesh finds, and a rotor that is hardly more than its
// ring bends in its plane as thin-ring theory says, f = n (n^2 - 1) / sqrt(n^2 + 1) * sqrt(E I /
// (rho A R^4)) / (2 pi), which shear and rotary inertia lower by about (h/R)^2 for n = 2.

#include "support/materials.h"

#include <ringmotor/mesh/rotor_sector.h>
#include <ringmotor/quantities/mode_search.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  const Material aluminium{68.9e9, 0.33, 2700., 0.};
  const MaterialTable material{{ids::rotor, aluminium}, {ids::lip_shell, aluminium}};

  RotorGeometry rotor_with(const ElementKind flange, const double bar_stiffness = 0.)
  {
    RotorGeometry rotor;
    rotor.flange_element       = flange;
    rotor.radial_bar_stiffness = bar_stiffness;
    return rotor;
  }

  Modes request(const std::vector<unsigned int> &nodal_diameters)
  {
    Modes modes;
    modes.nodal_diameters = nodal_diameters;
    modes.n_modes         = 2;
    return modes;
  }
} // namespace

TEST(Rotor, HasTheModesOfHalfAndWholeSectorAndRigidOnes)
{
  const SectorMesh half =
                       make_rotor_sector(RotorGeometry(), 90, SectorForm::half, 0, MPI_COMM_WORLD),
                   whole =
                       make_rotor_sector(RotorGeometry(), 90, SectorForm::whole, 0, MPI_COMM_WORLD);
  const CyclicSector half_sector(half, material, 2), whole_sector(whole, material, 2);
  ModeSolver half_solver(half_sector), whole_solver(whole_sector);
  for (const unsigned int k : {0u, 1u, 7u})
  {
    const double shift             = half_solver.shift_above(k, 2, 0.);
    const std::vector<Mode> modes  = half_solver.below(k, shift),
                            others = whole_solver.below(k, shift);
    ASSERT_EQ(modes.size(), others.size());
    EXPECT_EQ(std::count_if(modes.begin(), modes.end(), [](const Mode &m) { return m.rigid; }),
              k < 2 ? 2 : 0);
    for (unsigned int i = 0; i < modes.size(); ++i)
    {
      EXPECT_EQ(modes[i].rigid, others[i].rigid);
      if (!modes[i].rigid)
      {
        EXPECT_NEAR(modes[i].eigenvalue / others[i].eigenvalue, 1., 1e-10);
      }
    }
  }
}

TEST(RotorLong, HasErrorBarsThatHoldWhatAFarBetterMeshFinds)
{
  const auto search_on = [](const unsigned int level, const unsigned int degree)
  {
    const SectorMesh mesh =
        make_rotor_sector(RotorGeometry(), 90, SectorForm::half, level, MPI_COMM_WORLD);
    ModeSearch search(material, request({2, 7}));
    search.compute(mesh, degree);
    std::vector<Estimate> found;
    for (const FoundMode &mode : search.modes())
      found.push_back(mode.frequency);
    return found;
  };
  const std::vector<Estimate> best = search_on(1, 4);
  for (const unsigned int degree : {2u, 3u})
  {
    const std::vector<Estimate> found = search_on(0, degree);
    ASSERT_EQ(found.size(), best.size());
    for (unsigned int i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i].value, best[i].value, found[i].error + best[i].error) << degree;
  }
}

TEST(Rotor, WithHardlyAFlangeIsARing)
{
  RotorGeometry rotor;
  rotor.flange_thickness = 0.1e-3;
  rotor.lip_inner_radius = rotor.ring_inner_radius - 0.2e-3;
  rotor.lip_outer_radius = rotor.ring_inner_radius - 0.1e-3;
  const double height    = rotor.ring_outer_radius - rotor.ring_inner_radius;
  const double radius    = 0.5 * (rotor.ring_outer_radius + rotor.ring_inner_radius);
  const double n         = 2.;
  const double thin =
      n * (n * n - 1.) / std::sqrt(n * n + 1.) *
      std::sqrt(aluminium.young_modulus / aluminium.density * height * height / 12.) /
      (2. * M_PI * radius * radius);

  const SectorMesh mesh = make_rotor_sector(rotor, 90, SectorForm::half, 0, MPI_COMM_WORLD);
  ModeSearch search(material, request({2}));
  search.compute(mesh, 3);
  bool seen = false;
  for (const FoundMode &mode : search.modes())
    if (mode.content.family() == Family::in_plane)
    {
      EXPECT_NEAR(mode.frequency.value / thin, 1., 0.02);
      EXPECT_LT(mode.frequency.value, thin);
      seen = true;
    }
  EXPECT_TRUE(seen);
}
