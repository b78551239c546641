// SPDX-License-Identifier: LGPL-2.1-or-later

// Modes of rotor and teeth. Static compliance and modes together reproduce the response of the
// shifted stiffness K - Omega^2 M: between any nodes of the lip, between those of a tooth, and for
// pressure that travels around the lip.

#include "support/motor_model.h"

#include <ringmotor/motor/lip_amplification.h>
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/motor/tooth_modes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

using namespace ringmotor;
using namespace ringmotor::tests;
using Complex = std::complex<double>;

namespace
{
  /** The response of a ring's contact nodes to forces with k waves on one of them. */
  std::vector<Complex> response(const RingCompliance &ring, const unsigned int k,
                                const unsigned int component)
  {
    const unsigned int n = ring.n_sectors(), width = 3 * ring.n_nodes();
    std::vector<Complex> result(width);
    for (const unsigned int part : {0u, 1u})
    {
      std::vector<double> forces(n * width, 0.), motions(n * width, 0.);
      for (unsigned int j = 0; j < n; ++j)
        forces[j * width + component] = std::cos(2. * M_PI * k * j / n - part * M_PI / 2.);
      ring.add_motions(forces.data(), motions.data());
      // Motions of sector 0 due to cos and sin, the real parts of exp(-i k j alpha) and i times
      // that.
      for (unsigned int i = 0; i < width; ++i)
        result[i] += part == 0 ? Complex(motions[i]) : Complex(0., -motions[i]);
    }
    return result;
  }

  /** All nodes of the top are contact points. */
  MortarCoupling all_nodes_of(const ToothBody &tooth)
  {
    MortarCoupling all;
    for (unsigned int i = 0; i < tooth.whole_top.surface.nodes.size(); ++i)
      all.nodes.push_back({i, 1., {}});
    return all;
  }
} // namespace

TEST(RotorModes, MakeUpTheDynamicCompliance)
{
  const Parameters parameters = reference_motor();
  const ToothBody tooth(parameters, ContactDiscretisation::level(0));
  // On the same section as the modes, which follow waves around the rotor exactly: cells have to be
  // so narrow that they nearly do, too.
  ContactDiscretisation mesh = LipModes::discretisation(2);
  mesh.lip.n_around          = 2;
  const RotorBody body(parameters, mesh);
  const double pitch          = 2. * M_PI / 90.;
  const MortarCoupling mortar = couple(tooth.whole_top.surface, body.whole_lip.surface, pitch, 0.);
  const auto ring_of          = [&](const Condensation &condensation, const bool is_static)
  {
    const InterfaceCompliance interface(condensation);
    return RingCompliance(90, sector_compliance(interface, body.whole_lip.origin), mortar,
                          [&](const unsigned int k) {
                            return interface.through_cut(
                                k, is_static ? body.held(k) : std::vector<unsigned int>());
                          });
  };
  const RingCompliance at_rest = ring_of(body.condensed(), true);
  const double drive           = 2. * M_PI * 30e3;
  const RingModes modes        = LipModes(parameters, 2, drive, 30).at(tooth.whole_top.surface, 0.);
  for (const unsigned int m : {1u, 2u, 3u, 6u, 9u})
  {
    const unsigned int k = nodal_diameter_of_harmonic(parameters.motor, m);
    const Condensation shifted(body.sector, displacement_forms(body.lip), {}, {},
                               std::pow(m * drive, 2));
    const RingCompliance vibrating = ring_of(shifted, false);
    for (const unsigned int component : {0u, 1u, 2u})
    {
      const std::vector<Complex> expected = response(vibrating, k, component),
                                 rest     = response(at_rest, k, component);
      double largest                      = 0.;
      for (const Complex &motion : expected)
        largest = std::max(largest, std::abs(motion));
      for (unsigned int i = 0; i < expected.size(); ++i)
      {
        Complex found = rest[i];
        for (const RingMode &mode : modes[k])
        {
          const double square = std::pow(mode.angular_frequency, 2);
          found += mode.motion[i / 3][i % 3] *
                   std::conj(mode.motion[component / 3][component % 3]) *
                   (1. / (square - std::pow(m * drive, 2)) - 1. / square);
        }
        // Vectors above three times the frequency respond as at rest.
        EXPECT_LT(std::abs(found - expected[i]), (m < 6 ? 1e-3 : 2e-2) * largest) << m << " " << i;
      }
    }
  }
}

TEST(ToothModes, AreItsNaturalModesNextToTheFirstHarmonics)
{
  const Parameters parameters = reference_motor();
  const double drive          = 2. * M_PI * 30e3;
  const unsigned int level    = 1;
  const ToothBody tooth(parameters, tooth_modes_discretisation(level), /*is_clamped =*/true);
  const std::vector<Mode> natural = ModeSolver(tooth.sector).below(0, std::pow(20. * drive, 2));
  ASSERT_GE(natural.size(), 3u);
  // Whatever the number of harmonics: a loss factor of 0.001 makes resonances that narrow.
  for (const unsigned int n_harmonics : {20u, 30u, 45u, 60u, 67u, 90u})
  {
    const std::vector<RingMode> modes = tooth_modes(parameters, level, n_harmonics * drive,
                                                    tooth.whole_top.surface, all_nodes_of(tooth));
    ASSERT_GT(modes.size(), natural.size());
    for (unsigned int i = 0; i < 3; ++i)
      EXPECT_NEAR(modes[i].angular_frequency, std::sqrt(natural[i].eigenvalue),
                  1e-4 * modes[i].angular_frequency)
          << n_harmonics << " " << i;
  }
}

TEST(ToothModes, GiveTheDynamicComplianceThatTheToothHasWithoutThem)
{
  const Parameters parameters = reference_motor();
  const ToothBody tooth(parameters, tooth_modes_discretisation(2));
  const std::vector<RingMode> modes = tooth_modes(parameters, 2, 30. * 2. * M_PI * 30e3,
                                                  tooth.whole_top.surface, all_nodes_of(tooth));
  ASSERT_GT(modes.size(), 10u);
  const auto compliance = [&](const double frequency)
  {
    const Condensation condensation = tooth.condensed(frequency);
    return sector_compliance(InterfaceCompliance(condensation), tooth.whole_top.origin).at_rest;
  };
  const dealii::FullMatrix<double> at_rest = compliance(0.);
  // Below the first mode, between modes, and above several.
  for (const double frequency : {0.5 * modes[0].angular_frequency,
                                 0.5 * (modes[0].angular_frequency + modes[1].angular_frequency),
                                 0.6 * (modes[3].angular_frequency + modes[4].angular_frequency)})
  {
    const dealii::FullMatrix<double> vibrating = compliance(frequency);
    double largest = 0., error = 0.;
    for (unsigned int i = 0; i < at_rest.m(); ++i)
      for (unsigned int j = 0; j < at_rest.n(); ++j)
      {
        Complex found = at_rest(i, j);
        for (const RingMode &mode : modes)
        {
          const double square = std::pow(mode.angular_frequency, 2);
          found += mode.motion[i / 3][i % 3] * std::conj(mode.motion[j / 3][j % 3]) *
                   (1. / (square - frequency * frequency) - 1. / square);
        }
        error   = std::max(error, std::abs(found - vibrating(i, j)));
        largest = std::max(largest, std::abs(vibrating(i, j) - at_rest(i, j)));
      }
    EXPECT_LT(error, 0.03 * largest) << frequency;
  }
}

TEST(LipAmplification, IsThatOfTheShiftedStiffness)
{
  // The same pressure on the rotor with stiffness K - Omega^2 M, without modes.
  const Parameters parameters = reference_motor();
  const double drive          = 2. * M_PI * 30e3;
  const LipModes modes(parameters, 1, drive, 20);
  const LipAmplification amplification(parameters, modes, 1, 3);
  // As above; the static part is that of cells two degrees wide, under forces on their nodes.
  ContactDiscretisation mesh = LipModes::discretisation(1);
  mesh.lip.n_around          = 4;
  const RotorBody body(parameters, mesh);
  // Of that pressure on the motion along a direction (0 normal, 2 radial).
  const auto work =
      [&](const unsigned int k, const double frequency, const unsigned int direction = 0)
  {
    const std::vector<unsigned int> held;
    const Condensation condensation(body.sector, displacement_forms(body.lip), {}, {},
                                    frequency * frequency);
    const InterfaceCompliance interface(condensation);
    const dealii::FullMatrix<double> compliance = interface.compliance(k, held);
    double outer = 0., last = 0., sum = 0.;
    for (const SurfaceNode &node : body.lip.nodes)
    {
      outer = std::max(outer, node.place[0]);
      last  = std::max(last, node.place[1]);
    }
    std::vector<double> force(compliance.m()), along(compliance.m());
    for (unsigned int i = 0; i < body.lip.nodes.size(); ++i)
      if (const auto &place = body.lip.nodes[i].place; place[0] > outer - 1e-9)
      {
        const double share              = place[1] < 1e-9 || place[1] > last - 1e-9 ? 0.5 : 1.;
        force[3 * i]                    = share * std::cos(k * place[1]);
        force[3 * i + force.size() / 2] = -share * std::sin(k * place[1]);
        along[3 * i + direction]        = force[3 * i];
        along[3 * i + direction + force.size() / 2] = force[3 * i + force.size() / 2];
      }
    for (unsigned int i = 0; i < force.size(); ++i)
      for (unsigned int j = 0; j < force.size(); ++j)
        sum += along[i] * compliance(i, j) * force[j];
    return sum;
  };
  for (const unsigned int m : {1u, 2u, 3u})
  {
    EXPECT_EQ(amplification.nodal_diameter(m), 7 * m);
    const double expected = work(7 * m, m * drive) / work(7 * m, 1.);
    EXPECT_NEAR(amplification.at(m, m * drive), expected, 1e-3 * std::abs(expected)) << m;
    const double inwards = work(7 * m, m * drive, 2) / work(7 * m, m * drive);
    EXPECT_NEAR(amplification.radial_ratio(m, m * drive), inwards, 1e-3 * std::abs(inwards)) << m;
  }
}
