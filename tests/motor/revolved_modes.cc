// SPDX-License-Identifier: LGPL-2.1-or-later

// Waves around a body of revolution, found in its section, are those of its sector in 3D: modes of
// the reference rotor with solids, springs, and a flange as solids or as a shell tied to them, by
// number, frequency and shape, for waves of the order of the nodal diameter and for those that
// sectors see as the same. Their unknowns are far fewer; what a sector's polynomials around the
// ring cannot follow, they can.

#include "support/motor_model.h"

#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/structure/motion_products.h>
#include <ringmotor/structure/revolved_modes.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  double square(const double frequency)
  {
    return std::pow(2. * M_PI * frequency, 2);
  }

  class RevolvedModesOf : public ::testing::TestWithParam<ElementKind>
  {
  protected:
    RevolvedModesOf() : body(parameters(), discretisation()) {}

    static Parameters parameters()
    {
      Parameters parameters           = reference_motor();
      parameters.rotor.flange_element = GetParam();
      return parameters;
    }
    /** With cells of the third degree, 2 degrees wide. */
    static ContactDiscretisation discretisation()
    {
      ContactDiscretisation mesh = LipModes::discretisation(0);
      mesh.degree                = 3;
      return mesh;
    }

    const RotorBody body;
  };
} // namespace

TEST_P(RevolvedModesOf, AreThoseOfTheSector)
{
  ASSERT_TRUE(RevolvedSection::describes(body.sector));
  RevolvedModes in_section(body.sector);
  ModeSolver in_sector(body.sector);
  struct Case
  {
    unsigned int k;
    double up_to, tolerance; ///< Hz; of frequencies
  };
  // The more waves, the less polynomials over two degrees follow them.
  for (const Case &each :
       {Case{2, 80e3, 1e-8}, Case{7, 100e3, 1e-7}, Case{40, 600e3, 3e-3}, Case{45, 600e3, 3e-3}})
  {
    const std::vector<Mode> modes    = in_section.below(each.k, square(each.up_to)),
                            expected = in_sector.below(each.k, square(each.up_to));
    ASSERT_EQ(modes.size(), expected.size()) << each.k;
    EXPECT_GE(modes.size(), 4u) << each.k;
    for (unsigned int i = 0; i < modes.size(); ++i)
    {
      EXPECT_NEAR(modes[i].frequency(), expected[i].frequency(),
                  each.tolerance * expected[i].frequency())
          << each.k << ", mode " << i;
      // Polynomials of the sector are too stiff, never too soft.
      EXPECT_LT(modes[i].frequency(), (1. + 1e-9) * expected[i].frequency()) << each.k;
    }
  }
}

TEST_P(RevolvedModesOf, MoveTheSectorAsItsModesDo)
{
  RevolvedModes in_section(body.sector);
  ModeSolver in_sector(body.sector);
  const unsigned int k = 7;
  const double shift   = square(80e3);
  const auto modes = in_section.below(k, shift), expected = in_sector.below(k, shift);
  ASSERT_EQ(modes.size(), expected.size());
  const std::vector<LinearForm> displacements = displacement_forms(body.lip);
  for (unsigned int i = 0; i < modes.size(); ++i)
  {
    const std::vector<double> motion    = on_surface(body.sector, displacements, modes[i]),
                              of_sector = on_surface(body.sector, displacements, expected[i]);
    double product = 0., squares = 0., largest = 0.;
    for (unsigned int j = 0; j < motion.size(); ++j)
    {
      product += motion[j] * of_sector[j];
      squares += of_sector[j] * of_sector[j];
      largest = std::max(largest, std::abs(of_sector[j]));
    }
    const double sign = product > 0. ? 1. : -1.;
    EXPECT_NEAR(sign * product, squares, 1e-5 * squares) << i;
    for (unsigned int j = 0; j < motion.size(); ++j)
      ASSERT_NEAR(sign * motion[j], of_sector[j], 1e-4 * largest) << i << ", " << j;
    // Its energies on the sector, by all three dimensions.
    const MotionProducts products = motion_products(body.sector, {&modes[i].motion}).front();
    EXPECT_NEAR(products.mass, 1., 1e-6) << i;
    EXPECT_NEAR(products.total_stiffness(), modes[i].eigenvalue, 1e-6 * modes[i].eigenvalue) << i;
  }
}

TEST_P(RevolvedModesOf, HaveTheOrdersThatSectorsSeeAsTheSame)
{
  const RevolvedModes modes(body.sector);
  EXPECT_EQ(modes.orders(7), (std::vector<int>{7, -83, 97}));
  // Those of -45 and -135 are conjugate to these.
  EXPECT_EQ(modes.orders(45), (std::vector<int>{45, 135}));
}

INSTANTIATE_TEST_SUITE_P(Rotors, RevolvedModesOf,
                         ::testing::Values(ElementKind::solid, ElementKind::shell),
                         [](const auto &info)
                         { return info.param == ElementKind::shell ? "Shell" : "Solid"; });

TEST(RevolvedSection, IsNotThatOfABodyWithTeeth)
{
  const ToothBody tooth(reference_motor(), ContactDiscretisation::level(0));
  EXPECT_FALSE(RevolvedSection::describes(tooth.sector));
}
