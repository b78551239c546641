// SPDX-License-Identifier: LGPL-2.1-or-later

// Modes of the rotor: rigid motions of a rotor without bars are recognised, half and whole sector
// agree, error bars contain the results of a much finer mesh. With a shell flange the frequencies
// and the lip compliance approach those with solid cells throughout as the flange gets thinner. A
// stiff rotor on soft bars is a rigid body on springs: pi R k against shifts, R the radius at which
// the bars support it and k their stiffness per length, and pi R k h^2/12 against tilts about their
// middle, h their height. And a rotor that is little more than its ring bends in its plane as in
// thin-ring theory, f = n (n^2 - 1) / sqrt(n^2 + 1) * sqrt(E I / (rho A R^4)) / (2 pi), which shear
// and rotary inertia lower by about (h/R)^2 for n = 2.

#include "support/materials.h"
#include "support/record.h"
#include "support/same_modes.h"

#include <ringmotor/mesh/rotor_sector.h>
#include <ringmotor/structure/cyclic_factors.h>
#include <ringmotor/structure/surface_load.h>
#include <ringmotor/wave/mode_search.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

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

class RotorForms : public testing::TestWithParam<ElementKind>
{
};

TEST_P(RotorForms, HaveTheSameModesAndRigidOnes)
{
  const RotorGeometry rotor = rotor_with(GetParam());
  const SectorMesh half     = make_rotor_sector(rotor_body(rotor, 90), SectorForm::half, {},
                                                MPI_COMM_WORLD),
                   whole    = make_rotor_sector(rotor_body(rotor, 90), SectorForm::whole, {},
                                                MPI_COMM_WORLD);
  const CyclicSector half_sector(half, material, 2), whole_sector(whole, material, 2);
  expect_same_modes(half_sector, whole_sector, {0, 1, 7}, 2);
}

INSTANTIATE_TEST_SUITE_P(Flange, RotorForms,
                         testing::Values(ElementKind::solid, ElementKind::shell),
                         [](const auto &info)
                         { return info.param == ElementKind::solid ? "Solid" : "Shell"; });

TEST(RotorLong, HasErrorBarsThatHoldWhatAFarBetterMeshFinds)
{
  for (const ElementKind flange : {ElementKind::solid, ElementKind::shell})
    for (const double bar_stiffness : {0., 1e9})
    {
      const auto search_on = [&](const unsigned int level, const unsigned int degree)
      {
        const SectorMesh mesh =
            make_rotor_sector(rotor_body(rotor_with(flange, bar_stiffness), 90), SectorForm::half,
                              RotorGrading::level(level), MPI_COMM_WORLD);
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
          EXPECT_NEAR(found[i].value, best[i].value, found[i].error() + best[i].error()) << degree;
      }
    }
}

namespace
{
  /** Quantities compared between a shell and a solid flange. */
  struct Findings
  {
    std::map<std::pair<unsigned int, Family>, double> frequency;
    double lip_compliance; ///< mean axial displacement of the lip under a unit pressure wave, n = 7
  };

  Findings findings(const RotorGeometry &rotor, const unsigned int level, const unsigned int degree)
  {
    const SectorMesh mesh = make_rotor_sector(rotor_body(rotor, 90), SectorForm::half,
                                              RotorGrading::level(level), MPI_COMM_WORLD);
    const CyclicSector sector(mesh, material, degree);
    Findings found;
    ModeSolver solver(sector);
    for (const unsigned int k : {0u, 2u, 3u, 7u})
      for (const Mode &mode : nearest_elastic(solver.lowest(k, 2), 2, 0.))
        found.frequency[{k, mode_content(sector, mode).family()}] = mode.frequency();

    constexpr unsigned int k = 7;
    const Traction wave      = [](const Point<3> &x)
    {
      return std::array<std::complex<double>, 3>{
          {0., 0., std::polar(1., -7. * std::atan2(x[1], x[0]))}};
    };
    const SectorMotion forces       = rotor.flange_element == ElementKind::solid
                                          ? face_load(sector, ids::lip, wave)
                                          : lower_face_load(sector, ids::lip_shell, wave);
    const std::vector<double> loads = sector.loads_of(k, forces);
    std::vector<double> unknowns    = loads;
    CyclicFactors factors(sector);
    factors.factorise(k, 0.);
    factors.solve(unknowns);
    const double area = 0.5 * M_PI / 90. *
                        (std::pow(rotor.lip_outer_radius, 2) - std::pow(rotor.lip_inner_radius, 2));
    found.lip_compliance =
        std::inner_product(loads.begin(), loads.end(), unknowns.begin(), 0.) / area;
    return found;
  }
} // namespace

TEST(RotorLong, HasTheSameShellAndSolidFlange)
{
  std::vector<double> difference; ///< of the compliances, by thickness
  for (const double thickness : {0.6e-3, 0.3e-3, 0.15e-3})
  {
    RotorGeometry solid    = rotor_with(ElementKind::solid, 1e9),
                  shell    = rotor_with(ElementKind::shell, 1e9);
    solid.flange_thickness = shell.flange_thickness = thickness;
    const Findings of_solid = findings(solid, 1, 3), of_shell = findings(shell, 1, 3);
    ASSERT_EQ(of_solid.frequency.size(), of_shell.frequency.size());
    for (const auto &[which, frequency] : of_solid.frequency)
    {
      ASSERT_EQ(of_shell.frequency.count(which), 1);
      EXPECT_NEAR(of_shell.frequency.at(which) / frequency, 1., 1e-3) << which.first;
    }
    difference.push_back(std::abs(of_shell.lip_compliance / of_solid.lip_compliance - 1.));
    record("relative difference of the lip's compliances, flange of 0.6, 0.3, 0.15 mm",
           difference.back());
    EXPECT_LT(difference.back(), 2e-3) << thickness;
  }
  EXPECT_LT(difference[1], difference[0]);
  EXPECT_LT(difference[2], difference[1]);
}

TEST(Rotor, OnSoftBarsMovesAsARigidBody)
{
  for (const ElementKind flange : {ElementKind::solid, ElementKind::shell})
  {
    // Mass and moments of inertia of a ring of rectangular section about a diameter at height z.
    double mass = 0., moment = 0., inertia = 0.;
    RotorGeometry rotor      = rotor_with(flange, 1e6);
    rotor.radial_bar_height  = 1.5e-3;
    const double bars_middle = rotor.ring_upper_face - 0.5 * rotor.radial_bar_height;
    const auto add_ring =
        [&](const double inner, const double outer, const double low, const double high)
    {
      const double m = aluminium.density * M_PI * (outer * outer - inner * inner) * (high - low);
      const double z = 0.5 * (low + high) - bars_middle;
      mass += m;
      moment += m * z;
      inertia +=
          m * (0.25 * (outer * outer + inner * inner) + std::pow(high - low, 2) / 12. + z * z);
    };
    add_ring(rotor.ring_inner_radius, rotor.ring_outer_radius, rotor.ring_lower_face,
             rotor.ring_upper_face);
    add_ring(rotor.lip_inner_radius, rotor.ring_inner_radius, rotor.flange_lower_face,
             rotor.flange_lower_face + rotor.flange_thickness);
    // Shift x of the bars' middle and tilt; both move the center of mass, c above the bars' middle:
    // K = diag(k, k_t), M = [m, m c; m c, J].
    const double k   = M_PI * rotor.ring_inner_radius * rotor.radial_bar_stiffness;
    const double k_t = k * std::pow(rotor.radial_bar_height, 2) / 12.;
    const double a = mass * inertia - moment * moment, b = k * inertia + k_t * mass;
    const double root = std::sqrt(b * b - 4. * a * k * k_t);

    const SectorMesh mesh =
        make_rotor_sector(rotor_body(rotor, 90), SectorForm::half, {}, MPI_COMM_WORLD);
    const CyclicSector sector(mesh, material, 3);
    std::vector<double> eigenvalues;
    for (const Mode &mode : ModeSolver(sector).lowest(1, 2))
      eigenvalues.push_back(mode.eigenvalue);
    std::sort(eigenvalues.begin(), eigenvalues.end());
    EXPECT_NEAR(eigenvalues[0] / ((b - root) / (2. * a)), 1., 2e-3);
    EXPECT_NEAR(eigenvalues[1] / ((b + root) / (2. * a)), 1., 2e-3);
  }
}

TEST(Rotor, WithHardlyAFlangeIsARing)
{
  RotorGeometry rotor    = rotor_with(ElementKind::solid);
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

  const SectorMesh mesh =
      make_rotor_sector(rotor_body(rotor, 90), SectorForm::half, {}, MPI_COMM_WORLD);
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
