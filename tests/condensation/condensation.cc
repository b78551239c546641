// SPDX-License-Identifier: LGPL-2.1-or-later

// Condensation against solutions with all unknowns: the compliance of a rotor's lip against
// CyclicFactors and, where rigid motions are constrained, against one sparse factorisation of the
// stiffness bordered by the constraining loads. Known exactly: a constrained free body follows its
// support as a rigid body and takes no load; a stiff rotor on soft bars tilts against pi R k h^2/12
// (see tests/wave/rotor.cc); a tooth whose foot moves as a rigid body moves as a rigid body.

#include "support/direct_sector.h"

#include <ringmotor/condensation/interface_compliance.h>
#include <ringmotor/contact/contact_surface.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/rotor_sector.h>
#include <ringmotor/structure/cyclic_factors.h>
#include <ringmotor/structure/modes.h>
#include <ringmotor/structure/surface_load.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;
using Complex = std::complex<double>;

namespace
{
  constexpr unsigned int n_teeth = 90;
  const Material aluminium{68.9e9, 0.33, 2700., 0.};

  RotorGeometry rotor_with(const ElementKind flange, const double bar_stiffness)
  {
    RotorGeometry rotor;
    rotor.flange_element       = flange;
    rotor.radial_bar_stiffness = bar_stiffness;
    return rotor;
  }

  /** The rotor with a condensed lip, loaded on the ring's top and around its bore. */
  struct Rotor
  {
    RotorGeometry geometry;
    SectorMesh mesh;
    CyclicSector sector;
    ContactSurface lip;
    std::vector<LinearForm> forms;
    std::vector<CondensationSupport> supports; ///< rise, turn

    explicit Rotor(const RotorGeometry &geometry)
        : geometry(geometry),
          // Even cells: what two solvers differ by is roundoff, which small cells magnify.
          mesh(make_rotor_sector(rotor_body(geometry, n_teeth), SectorForm::half, {},
                                 MPI_COMM_WORLD, {2, 1, 1.})),
          sector(mesh, {{ids::rotor, aluminium}, {ids::lip_shell, aluminium}}, 2),
          lip(geometry.flange_element == ElementKind::solid
                  ? solid_surface(sector, ids::lip)
                  : shell_surface(sector, ids::lip_shell)),
          forms(displacement_forms(lip))
    {
      const SectorMotion up     = face_load(sector, ids::ring_top,
                                            [](const Point<3> &) {
                                          return std::array<Complex, 3>{{0., 0., 1.}};
                                        }),
                         around = face_load(
                             sector, ids::ring_bore,
                             [](const Point<3> &x)
                             {
                               const Complex i_r(0., 1. / std::hypot(x[0], x[1]));
                               return std::array<Complex, 3>{{-i_r * x[1], i_r * x[0], 0.}};
                             });
      for (const unsigned int part : {0u, 1u})
      {
        const dealii::Vector<double> load = sector.from_forces(part == 0 ? up : around)[part];
        supports.push_back({part, {}});
        for (unsigned int dof = 0; dof < load.size(); ++dof)
          if (load[dof] != 0.)
            supports.back().load.emplace_back(dof, load[dof] / load.l1_norm());
      }
    }

    /** The rigid motions constrained by the supports only. */
    std::vector<unsigned int> held(const unsigned int k) const
    {
      if (k > 1)
        return {};
      return k == 1 && geometry.radial_bar_stiffness > 0. ? std::vector<unsigned int>{0}
                                                          : std::vector<unsigned int>{0, 1};
    }

    std::vector<std::vector<double>> held_loads(const unsigned int k) const
    {
      std::vector<std::vector<double>> loads;
      for (const unsigned int support : held(k))
        loads.push_back(loads_of_form(sector, k, supports[support].part, supports[support].load));
      return loads;
    }

    /** Loads of all forms on the real, then on the imaginary field. */
    std::vector<std::vector<double>> loads(const unsigned int k) const
    {
      std::vector<std::vector<double>> loads;
      for (const unsigned int part : {0u, 1u})
        for (const LinearForm &form : forms)
          loads.push_back(loads_of_form(sector, k, part, form));
      return loads;
    }
  };

  struct RotorCase
  {
    ElementKind flange;
    double bar_stiffness;
  };

  class Condensed : public testing::TestWithParam<RotorCase>
  {
  };
} // namespace

TEST_P(Condensed, EqualsTheSolutionWithAllUnknowns)
{
  const Rotor rotor(rotor_with(GetParam().flange, GetParam().bar_stiffness));
  const Condensation condensation(rotor.sector, rotor.forms, {}, rotor.supports, 0.);
  CyclicFactors factors(rotor.sector);
  for (const unsigned int k : {0u, 1u, 2u, 7u, n_teeth / 2})
  {
    SCOPED_TRACE(k);
    DirectSector direct(rotor.sector, k, 0., rotor.held_loads(k));
    const dealii::FullMatrix<double> compliance =
        InterfaceCompliance(condensation).compliance(k, rotor.held(k));
    const auto loads = rotor.loads(k);
    expect_solutions(
        compliance, loads, [&](const std::vector<double> &load) { return direct.solve(load); },
        1e-9);
    if (rotor.held(k).empty())
    {
      factors.factorise(k, 0.);
      expect_solutions(
          compliance, loads,
          [&](std::vector<double> load)
          {
            factors.solve(load);
            return load;
          },
          1e-9);
    }
    for (unsigned int support = 0; support < rotor.held(k).size(); ++support)
    {
      // P^T u = 1 for this support, 0 for others
      std::vector<double> given(rotor.sector.n_unknowns(), 0.);
      for (unsigned int s = 0; s < rotor.held(k).size(); ++s)
        given.push_back(s == support ? 1. : 0.);
      const std::vector<double> solution = direct.solve(given);
      const SupportMotion motion =
          condensation.support_motion(k, rotor.held(k), rotor.held(k)[support]);
      for (unsigned int i = 0; i < loads.size(); ++i)
        EXPECT_NEAR(motion.interface[i],
                    std::inner_product(loads[i].begin(), loads[i].end(), solution.begin(), 0.),
                    1e-9);
      // Relative to the stiffness of the lip: that of a rigid motion is pure roundoff.
      EXPECT_NEAR(motion.stiffness, -solution[rotor.sector.n_unknowns() + support],
                  1e-9 / compliance(0, 0));
    }
  }
}

TEST_P(Condensed, EqualsTheSolutionWithAllUnknownsWhenItVibrates)
{
  const Rotor rotor(rotor_with(GetParam().flange, GetParam().bar_stiffness));
  ModeSolver solver(rotor.sector);
  CyclicFactors factors(rotor.sector);
  for (const unsigned int k : {0u, 1u, 7u})
  {
    SCOPED_TRACE(k);
    std::vector<Mode> modes = nearest_elastic(solver.lowest(k, 3), 3, 0.);
    // A tilt on bars is so soft that near its frequency the roundoff of the ring's stiffness is
    // noticeable.
    if (k == 1 && GetParam().bar_stiffness > 0.)
      modes.erase(modes.begin());
    // Below all elastic modes, and between two of them
    for (const double shift :
         {0.5 * modes[0].eigenvalue, 0.5 * (modes[0].eigenvalue + modes[1].eigenvalue)})
    {
      const Condensation condensation(rotor.sector, rotor.forms, {}, rotor.supports, shift);
      factors.factorise(k, shift);
      expect_solutions(
          InterfaceCompliance(condensation).compliance(k, {}), rotor.loads(k),
          [&](std::vector<double> load)
          {
            factors.solve(load);
            return load;
          },
          1e-9);
    }
  }
}

TEST_P(Condensed, KnowsItsInsideAsTheSolutionWithAllUnknownsDoes)
{
  const Rotor rotor(rotor_with(GetParam().flange, GetParam().bar_stiffness));
  const Condensation condensation(rotor.sector, rotor.forms, {}, rotor.supports, 0., true);
  for (const unsigned int k : {0u, 1u, 7u, n_teeth / 2})
  {
    SCOPED_TRACE(k);
    DirectSector direct(rotor.sector, k, 0., rotor.held_loads(k));
    const auto forms = rotor.loads(k);
    std::vector<CondensationLoad> loads;
    for (unsigned int l = 0; l < 2; ++l)
    {
      loads.emplace_back();
      for (unsigned int i = 0; i < forms.size(); ++i)
        loads.back().forces.push_back(std::cos(1. + i * (2. + l)));
      for (unsigned int s = 0; s < rotor.held(k).size(); ++s)
        loads.back().supports.push_back(1e-6 * (1. + s + l));
    }
    const std::vector<SectorMotion> motions = condensation.interior(k, rotor.held(k), loads);
    ASSERT_EQ(motions.size(), loads.size());
    for (unsigned int l = 0; l < loads.size(); ++l)
    {
      std::vector<double> given(rotor.sector.n_unknowns(), 0.);
      for (unsigned int i = 0; i < forms.size(); ++i)
        for (unsigned int j = 0; j < given.size(); ++j)
          given[j] += loads[l].forces[i] * forms[i][j];
      given.insert(given.end(), loads[l].supports.begin(), loads[l].supports.end());
      std::vector<double> solution = direct.solve(given);
      solution.resize(rotor.sector.n_unknowns());
      expect_motion(motions[l], rotor.sector.expand(k, solution), 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rotors, Condensed,
    testing::Values(RotorCase{ElementKind::solid, 0.}, RotorCase{ElementKind::solid, 1e9},
                    RotorCase{ElementKind::shell, 0.}, RotorCase{ElementKind::shell, 1e9}),
    [](const auto &info)
    {
      return std::string(info.param.flange == ElementKind::solid ? "Solid" : "Shell") +
             (info.param.bar_stiffness > 0. ? "OnBars" : "Free");
    });

TEST(Condensation, FollowsItsSupportsAsARigidBody)
{
  for (const ElementKind flange : {ElementKind::solid, ElementKind::shell})
    for (const double bar_stiffness : {0., 1e9})
    {
      const Rotor rotor(rotor_with(flange, bar_stiffness));
      const Condensation condensation(rotor.sector, rotor.forms, {}, rotor.supports, 0.);
      const double stiff       = 1. / InterfaceCompliance(condensation).compliance(0, {0, 1})(0, 0);
      const SupportMotion up   = condensation.support_motion(0, {0, 1}, 0),
                          turn = condensation.support_motion(0, {0, 1}, 1);
      EXPECT_NEAR(up.stiffness / stiff, 0., 1e-9);
      EXPECT_NEAR(turn.stiffness / stiff, 0., 1e-9);
      const unsigned int n = rotor.forms.size();
      // The load is not quite normalised: its two in-plane components count separately.
      const double angle = -turn.interface[n + 1] / rotor.lip.nodes[0].place[0];
      EXPECT_NEAR(angle * rotor.geometry.ring_inner_radius, 1., M_PI / n_teeth);
      for (unsigned int i = 0; i < n; ++i)
      {
        EXPECT_NEAR(up.interface[i], i % 3 == 0 ? 1. : 0., 1e-9);
        EXPECT_NEAR(up.interface[n + i], 0., 1e-9);
        EXPECT_NEAR(turn.interface[i], 0., 1e-9);
        EXPECT_NEAR(turn.interface[n + i],
                    i % 3 == 1 ? -angle * rotor.lip.nodes[i / 3].place[0] : 0., 1e-9);
      }
    }
}

namespace
{
  /** A rotor on soft bars that tilts, and its tilting stiffness over that of a rigid ring,
   * pi R k h^2/12. */
  struct TiltOnBars
  {
    Rotor rotor;
    SupportMotion tilt;
    double angle;     ///< which gives the ring's top a unit mean rise
    double stiffness; ///< relative

    TiltOnBars(const ElementKind flange, const double bar_stiffness)
        : rotor(on_bars(flange, bar_stiffness))
    {
      const RotorGeometry &geometry = rotor.geometry;
      const Condensation condensation(rotor.sector, rotor.forms, {}, rotor.supports, 0.);
      tilt = condensation.support_motion(1, {0}, 0);

      // Unit mean of the rise phi r exp(-i theta) over the ring's top
      const double half = M_PI / n_teeth;
      const auto moment = [&](const int power)
      {
        return (std::pow(geometry.ring_outer_radius, power) -
                std::pow(geometry.ring_inner_radius, power)) /
               power;
      };
      angle = moment(2) / moment(3) / (std::sin(half) / half);

      const double rigid = M_PI * geometry.ring_inner_radius * bar_stiffness *
                           std::pow(geometry.radial_bar_height, 2) / 12.;
      stiffness = n_teeth * tilt.stiffness / (rigid * angle * angle);
    }

    static RotorGeometry on_bars(const ElementKind flange, const double bar_stiffness)
    {
      RotorGeometry geometry     = rotor_with(flange, bar_stiffness);
      geometry.radial_bar_height = 1.5e-3;
      return geometry;
    }
  };
} // namespace

TEST(Condensation, TiltsARotorAgainstItsBars)
{
  for (const ElementKind flange : {ElementKind::solid, ElementKind::shell})
  {
    const TiltOnBars soft(flange, 1e7), stiff(flange, 1e8);
    // The ring's own compliance in series is proportional to the stiffness of the bars, and removed
    // by extrapolation. Bars so soft that it can be neglected vanish in the roundoff of the ring.
    EXPECT_NEAR((10. / soft.stiffness - 1. / stiff.stiffness) / 9., 1., 3e-5);

    const Rotor &rotor            = soft.rotor;
    const RotorGeometry &geometry = rotor.geometry;
    const double bars_middle      = geometry.ring_upper_face - 0.5 * geometry.radial_bar_height;
    const double arm              = geometry.flange_lower_face - bars_middle;
    const unsigned int n          = rotor.forms.size();
    for (unsigned int i = 0; i < n; ++i)
    {
      // u = phi (x e_z - (z - z_bars) e_x), and the same about the other axis, -i times that
      const Point<2> &place  = rotor.lip.nodes[i / 3].place;
      const Complex wave     = std::polar(soft.angle, -place[1]);
      const Complex expected = i % 3 == 0   ? place[0] * wave
                               : i % 3 == 1 ? Complex(0., -arm) * wave
                                            : -arm * wave;
      EXPECT_NEAR(soft.tilt.interface[i], expected.real(), 1e-3);
      EXPECT_NEAR(soft.tilt.interface[n + i], expected.imag(), 1e-3);
    }
  }
}
