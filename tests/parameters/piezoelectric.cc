// SPDX-License-Identifier: LGPL-2.1-or-later

// Constants of piezoelectric ceramics. Expected values: published sets of which both forms are
// known, within the digits given; the coupling factors that standards define; the mistakes people
// make.

#include "sample.h"

#include <cmath>

using namespace ringmotor;
using ringmotor::sample::expect_message;
using ringmotor::sample::message_of;
using ringmotor::sample::with;

namespace
{
  /** PZT-4 after the data sheet in the IEEE standard on piezoelectricity, e-form. */
  Piezoelectricity pzt_4()
  {
    Piezoelectricity set;
    set.c11 = 138.999e9, set.c12 = 77.8366e9, set.c13 = 74.2836e9, set.c33 = 115.412e9;
    set.c44        = 25.641e9;
    set.coupling31 = -5.20279, set.coupling33 = 15.0804, set.coupling15 = 12.7179;
    set.permittivity11 = 762.5 * 8.854e-12, set.permittivity33 = 663.2 * 8.854e-12;
    return set;
  }
} // namespace

// The data sheet has d31 = -123, d33 = 289, d15 = 496 pC/N and relative permittivities of the free
// body 1475 and 1300.
TEST(Piezoelectricity, BothForms)
{
  Piezoelectricity set = pzt_4();
  set.form             = CouplingForm::d;
  set.coupling31 = -123e-12, set.coupling33 = 289e-12, set.coupling15 = 496e-12;
  set.permittivity_at = PermittivityAt::stress;
  set.permittivity11 = 1475. * 8.854e-12, set.permittivity33 = 1300. * 8.854e-12;
  const PiezoelectricLaw from_d = set.law(), from_e = pzt_4().law();
  EXPECT_NEAR(from_d.coupling[2][0], -5.20279, 0.005 * 5.2);
  EXPECT_NEAR(from_d.coupling[2][2], 15.0804, 0.005 * 15.);
  EXPECT_NEAR(from_d.coupling[1][3], 12.7179, 0.005 * 12.7);
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(from_d.permittivity[i][i] / from_e.permittivity[i][i], 1., 0.01);
}

// e and the permittivity of the free body: the difference is e c^-1 e^T.
TEST(Piezoelectricity, ClampedFromFreePermittivity)
{
  Piezoelectricity set = pzt_4();
  set.permittivity_at  = PermittivityAt::stress;
  set.permittivity11 = 1475. * 8.854e-12, set.permittivity33 = 1300. * 8.854e-12;
  EXPECT_NEAR(set.law().permittivity[0][0], 762.5 * 8.854e-12, 0.01 * 762.5 * 8.854e-12);
  EXPECT_NEAR(set.law().permittivity[2][2], 663.2 * 8.854e-12, 0.01 * 663.2 * 8.854e-12);
}

// k_t of two sets in tables of thickness modes
TEST(Piezoelectricity, ThicknessCoupling)
{
  Piezoelectricity set;
  set.c33 = 115e9, set.coupling33 = 14.1, set.permittivity33 = 5.841e-9;
  EXPECT_NEAR(set.thickness_coupling(), 0.4778911, 1e-6);
  set.c33 = 110e9, set.coupling33 = 15.8, set.permittivity33 = 7.3e-9;
  EXPECT_NEAR(set.thickness_coupling(), 0.486987, 5e-7);
}

TEST(Piezoelectricity, SymmetryOfThePoledCeramic)
{
  const PiezoelectricLaw law = Piezoelectricity().law();
  EXPECT_EQ(law.stiffness[5][5], 0.5 * (139e9 - 77.84e9)); // xy
  EXPECT_EQ(law.stiffness[3][3], 25.64e9);                 // yz
  EXPECT_EQ(law.stiffness[4][4], 25.64e9);                 // xz
  EXPECT_EQ(law.coupling[0][4], 12.71);                    // x and xz
  EXPECT_EQ(law.coupling[1][3], 12.71);                    // y and yz
  EXPECT_EQ(law.coupling[2][5], 0.);
}

TEST(Piezoelectricity, ImpossibleConstantsAreRefused)
{
  const auto expect_refused =
      [](const std::vector<std::string> &entries, const std::vector<std::string> &words)
  {
    const Parameters parameters = with(entries);
    expect_message(message_of([&] { parameters.piezoelectricity.check(); }), words);
  };
  expect_refused({"Piezoelectricity/Stiffness c12 = 140e9"},
                 {"Piezoelectricity/Stiffness c12 = 1.4e+11", "less than c11 = 1.39e+11"});
  expect_refused({"Piezoelectricity/Stiffness c13 = 120e9"},
                 {"Piezoelectricity/Stiffness c13 = 1.2e+11", "not positive definite", "1.12e+11"});
  expect_refused(
      {"Piezoelectricity/Permittivity at = stress", "Piezoelectricity/Permittivity 11 = 6e-9"},
      {"Piezoelectricity/Permittivity 11 = 6e-09", "coupling factor of 1 or more",
       "Permittivity at"});
  expect_refused({"Piezoelectricity/Coupling form = d"},
                 {"Piezoelectricity/Coupling 31 = -5.21", "m/V", "Coupling form = e"});
  EXPECT_NO_THROW(Piezoelectricity().check());
}

TEST(Piezoelectricity, LikelyMistakesAreTold)
{
  EXPECT_TRUE(Piezoelectricity().warnings().empty());
  Piezoelectricity set;
  set.coupling31 = 5.2;
  ASSERT_EQ(set.warnings().size(), 1);
  EXPECT_NE(set.warnings().front().find("same sign"), std::string::npos);
  set                 = Piezoelectricity();
  set.permittivity_at = PermittivityAt::stress; // but they are those of the clamped ceramic
  ASSERT_EQ(set.warnings().size(), 1);
  EXPECT_NE(set.warnings().front().find("Permittivity at"), std::string::npos);
  set            = Piezoelectricity();
  set.coupling33 = 1.508e-3; // in other units
  ASSERT_EQ(set.warnings().size(), 1);
  EXPECT_NE(set.warnings().front().find("k_t"), std::string::npos);
}
