// SPDX-License-Identifier: LGPL-2.1-or-later

// The choice among cures of errors: the cheapest ones that suffice.

#include <ringmotor/points/cures.h>

#include <gtest/gtest.h>

using namespace ringmotor;

namespace
{
  using Cures = std::set<Cure>;
} // namespace

TEST(Cures, AreTheCheapestThatSuffice)
{
  constexpr double target = 1.;
  // Each of them would do: shorter steps concern one point alone.
  EXPECT_EQ(
      cheapest_cures({{Cure::steps, 0.4}, {Cure::modes, 0.4}, {Cure::meshes, 0.5}}, 0., target),
      Cures{Cure::steps});
  // Three quarters of the squares vanish with steps and modes, more than that with meshes.
  EXPECT_EQ(
      cheapest_cures({{Cure::steps, 0.2}, {Cure::modes, 0.5}, {Cure::meshes, 0.5}}, 0., target),
      Cures{Cure::modes});
  EXPECT_EQ(
      cheapest_cures({{Cure::steps, 0.6}, {Cure::modes, 0.6}, {Cure::meshes, 0.6}}, 0., target),
      (Cures{Cure::steps, Cure::modes}));
  EXPECT_EQ(cheapest_cures({{Cure::steps, 0.1}, {Cure::meshes, 2.}}, 0.6, target),
            Cures{Cure::meshes});
  EXPECT_EQ(cheapest_cures({{Cure::steps, 0.3}, {Cure::meshes, 2.}}, 0.6, target),
            (Cures{Cure::steps, Cure::meshes}));
}

TEST(Cures, AreTakenAgainWhereOnceIsNotEnough)
{
  constexpr double target = 1.;
  // A step that is far too long does not call for finer meshes.
  EXPECT_EQ(
      cheapest_cures({{Cure::steps, 40.}, {Cure::modes, 0.1}, {Cure::meshes, 0.5}}, 0.1, target),
      Cures{Cure::steps});
  EXPECT_EQ(
      cheapest_cures({{Cure::steps, 40.}, {Cure::modes, 30.}, {Cure::meshes, 0.5}}, 0.1, target),
      (Cures{Cure::steps, Cure::modes}));
}

TEST(Cures, AreNoneWhereNothingHelps)
{
  EXPECT_EQ(cheapest_cures({{Cure::steps, 0.5}}, 1.1, 1.), Cures{});
  EXPECT_EQ(cheapest_cures({}, 1.1, 1.), Cures{});
  // An error that is zero needs no cure.
  EXPECT_EQ(cheapest_cures({{Cure::steps, 0.}, {Cure::meshes, 2.}}, 0., 1.), Cures{Cure::meshes});
}
