// SPDX-License-Identifier: LGPL-2.1-or-later

// The friction laws against their definitions, written out by hand for round numbers: values at
// zero, small and large slip, derivatives against finite differences, the memory of a contact node.
// Then one contact node on springs, whose slip and friction are the roots of scalar equations.

#include "support/dense_contact.h"

#include <ringmotor/contact/friction_law.h>
#include <ringmotor/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double mu_s = 0.5, mu_d = 0.3, decay_velocity = 0.2, weakening_length = 4e-6;
  constexpr double time_step = 5e-7, decay_length = decay_velocity * time_step;

  Friction friction_of(const FrictionLaw law)
  {
    Friction friction;
    friction.law                 = law;
    friction.static_coefficient  = mu_s;
    friction.dynamic_coefficient = mu_d;
    friction.decay_velocity      = decay_velocity;
    friction.weakening_length    = weakening_length;
    return friction;
  }

  double value(const FrictionLaw law, const double slip, const FrictionMemory &memory = {})
  {
    return friction_coefficient(friction_of(law), memory, slip, time_step).value;
  }

  /** Compares the derivative at a slip (m) with a central difference. */
  void expect_derivative(const FrictionLaw law, const double slip, const FrictionMemory &memory)
  {
    const double h = 1e-4 * slip;
    const double expected =
        (value(law, slip + h, memory) - value(law, slip - h, memory)) / (2. * h);
    const FrictionCoefficient found =
        friction_coefficient(friction_of(law), memory, slip, time_step);
    EXPECT_NEAR(found.derivative, expected, 1e-6 * (mu_s - mu_d) / std::max(slip, h)) << slip;
    EXPECT_LE(found.derivative, 0.);
  }

  const FrictionMemory stuck{true, 0.}, slipping{false, 1e-6};

  /**
   * One point on springs: pressed with 2 N, pulled by 1e-6 m along (0.6, 0.8), 2e-7 m/N. Returns
   * the distance slipped.
   */
  double slip_on_springs(const PointFriction &friction, const double start_force = 0.)
  {
    DenseContact problem(1, 0);
    for (unsigned int c = 0; c < 3; ++c)
      problem.compliance(c, c) = 2e-7;
    problem.free_motion[0][0]   = -2. * 2e-7;
    problem.free_motion[0][1]   = 0.6e-6;
    problem.free_motion[0][2]   = 0.8e-6;
    ContactState start          = problem.nothing();
    start.force[0][0]           = 2.;
    start.force[0][1]           = -0.6 * start_force;
    start.force[0][2]           = -0.8 * start_force;
    const ContactSolution found = solve_contact(problem, friction, {5e6, 5e6}, start);
    EXPECT_NEAR(found.state.force[0][0], 2., 1e-9);
    const double slip = std::hypot(found.motion[0][1], found.motion[0][2]);
    // Friction opposes the pull.
    EXPECT_NEAR(found.state.force[0][1] / found.state.force[0][2], 0.75, 1e-9);
    EXPECT_NEAR(1e-6 - 2e-7 * std::hypot(found.state.force[0][1], found.state.force[0][2]), slip,
                1e-15);
    return slip;
  }
} // namespace

TEST(FrictionLaws, HaveTheirValues)
{
  for (const FrictionMemory &memory : {stuck, slipping})
    for (const double slip : {0., 1e-12, 1e-7, 1e-5, 1.})
      EXPECT_EQ(value(FrictionLaw("coulomb"), slip, memory), mu_d);

  for (const double slip : {0., 1e-12, 1e-5, 1.})
  {
    EXPECT_EQ(value(FrictionLaw("static-dynamic"), slip, stuck), mu_s);
    EXPECT_EQ(value(FrictionLaw("static-dynamic"), slip, slipping), mu_d);
  }

  EXPECT_EQ(value(FrictionLaw("velocity"), 0.), mu_s);
  EXPECT_NEAR(value(FrictionLaw("velocity"), 1e-6 * decay_length), mu_s, 1e-6);
  EXPECT_NEAR(value(FrictionLaw("velocity"), decay_length), 0.373575888, 1e-9); // 0.3 + 0.2/e
  EXPECT_EQ(value(FrictionLaw("velocity"), 1.), mu_d);

  EXPECT_EQ(value(FrictionLaw("slip-weakening"), 0.), mu_s);
  EXPECT_NEAR(value(FrictionLaw("slip-weakening"), 1e-6), 0.45, 1e-12);
  EXPECT_NEAR(value(FrictionLaw("slip-weakening"), 3.999999e-6), mu_d, 1e-6);
  EXPECT_EQ(value(FrictionLaw("slip-weakening"), weakening_length), mu_d);
  EXPECT_EQ(value(FrictionLaw("slip-weakening"), 1.), mu_d);
}

TEST(FrictionLaws, HaveTheirDerivatives)
{
  for (const FrictionMemory &memory : {stuck, slipping})
    for (const FrictionLaw law : {FrictionLaw("coulomb"), FrictionLaw("static-dynamic"),
                                  FrictionLaw("velocity"), FrictionLaw("slip-weakening")})
      for (const double slip : {1e-11, 1e-8, decay_length, 1.5e-6, 1e-5, 1.})
        expect_derivative(law, slip, memory);
  // At rest, where only the one-sided derivative exists
  EXPECT_NEAR(
      friction_coefficient(friction_of(FrictionLaw("velocity")), stuck, 0., time_step).derivative,
      -(mu_s - mu_d) / decay_length, 1e-6 / decay_length);
  EXPECT_NEAR(friction_coefficient(friction_of(FrictionLaw("slip-weakening")), stuck, 0., time_step)
                  .derivative,
              -(mu_s - mu_d) / weakening_length, 1e-6 / weakening_length);
}

TEST(FrictionLaws, Remember)
{
  // Weakening continues from the end of the last step, however the slip is divided into steps.
  for (const double before : {0., 1e-6, 2.5e-6, 4e-6, 1.})
    EXPECT_NEAR(value(FrictionLaw("slip-weakening"), 0.5e-6, {false, before}),
                value(FrictionLaw("slip-weakening"), 0.5e-6 + before, {true, 0.}), 1e-12);
  // The velocity law depends on the velocity only.
  const Friction velocity = friction_of(FrictionLaw("velocity"));
  EXPECT_NEAR(friction_coefficient(velocity, stuck, 1e-8, time_step).value,
              friction_coefficient(velocity, slipping, 3e-8, 3. * time_step).value, 1e-12);
}

TEST(FrictionOfAPoint, SolvesTheScalarEquation)
{
  EXPECT_NEAR(slip_on_springs(coulomb(0.3)), 1e-6 - 2e-7 * 0.6, 1e-15);
  EXPECT_NEAR(slip_on_springs(coulomb(3.)), 0., 1e-15); // 6 N would hold it, the spring has 5 N

  const Friction velocity      = friction_of(FrictionLaw("velocity"));
  const PointFriction by_speed = [&](const unsigned int, const double slip)
  { return friction_coefficient(velocity, stuck, slip, 10. * time_step); };
  double low = 0., high = 1e-6; // slip - pull + compliance mu(slip) p grows with the slip
  for (unsigned int i = 0; i < 60; ++i)
  {
    const double middle                                = 0.5 * (low + high);
    const double mu                                    = 0.3 + 0.2 * std::exp(-middle / 1e-6);
    (middle - 1e-6 + 2e-7 * 2. * mu < 0. ? low : high) = middle;
  }
  EXPECT_NEAR(slip_on_springs(by_speed), low, 1e-15);

  const Friction weakening         = friction_of(FrictionLaw("slip-weakening"));
  const PointFriction by_slip_path = [&](const unsigned int, const double slip)
  { return friction_coefficient(weakening, stuck, slip, time_step); };
  // slip = pull - compliance p (0.5 - 0.2 slip/length)
  EXPECT_NEAR(slip_on_springs(by_slip_path), (1e-6 - 2e-7) / (1. - 4e-7 * 0.2 / 4e-6), 1e-15);
}

TEST(FrictionOfAPoint, MayJumpWhereItWeakensQuickly)
{
  // From 3 to 0.3 within 1e-7 m: friction falls by 5.4 N, the spring by 0.5 N. It may stick (the
  // pull of 5 N is below 6 N) or slip at 0.6 N; the third, intermediate solution is unstable.
  Friction friction           = friction_of(FrictionLaw("slip-weakening"));
  friction.static_coefficient = 3.;
  friction.weakening_length   = 1e-7;
  const PointFriction weakens = [&](const unsigned int, const double slip)
  { return friction_coefficient(friction, stuck, slip, time_step); };
  EXPECT_NEAR(slip_on_springs(weakens, 5.), 0., 1e-15);
  EXPECT_NEAR(slip_on_springs(weakens, 0.6), 1e-6 - 2e-7 * 0.6, 1e-15);
}

TEST(FrictionOfAPoint, RemembersTheDistanceOnlyWhereItMatters)
{
  const Friction friction    = friction_of(FrictionLaw("slip-weakening"));
  const FrictionLawBase &law = law_of(friction);
  const auto agree           = [&](const double found, const double assumed)
  {
    FrictionMemory memory{false, assumed * weakening_length};
    const bool agreed =
        law.settle(friction, {false, found * weakening_length}, PointStatus::slip, false, memory);
    EXPECT_EQ(memory.slipped, found * weakening_length);
    return agreed;
  };
  EXPECT_TRUE(agree(0.5, 0.5));
  EXPECT_FALSE(agree(0.5, 0.6));
  EXPECT_FALSE(agree(0.9, 1.1));
  EXPECT_TRUE(agree(2., 3.)); // the dynamic coefficient, however far
}

TEST(FrictionOfManyPoints, FallsFromTheStaticCoefficientWhereThePullExceedsIt)
{
  // As above, but pulled by 0.1 N to 12 N; from a start without forces all contact nodes have the
  // static coefficient at first. Those pulled with less than 6 N stick, the others slip at 0.6 N.
  constexpr unsigned int n_points = 60;
  constexpr double compliance     = 2e-7; // m/N
  Friction weakening              = friction_of(FrictionLaw("slip-weakening")),
           velocity               = friction_of(FrictionLaw("velocity"));
  weakening.static_coefficient = velocity.static_coefficient = 3.;
  weakening.weakening_length                                 = 1e-7;
  velocity.decay_velocity                                    = 1e-8 / time_step;
  DenseContact problem(n_points, 0);
  for (unsigned int i = 0; i < n_points; ++i)
  {
    for (unsigned int c = 0; c < 3; ++c)
      problem.compliance(3 * i + c, 3 * i + c) = compliance;
    problem.free_motion[i][0] = -2. * compliance;
    problem.free_motion[i][1] = (0.1 + 0.2 * i) * compliance;
  }
  for (const Friction &friction : {weakening, velocity})
  {
    const PointFriction falls = [&](const unsigned int, const double slip)
    { return friction_coefficient(friction, stuck, slip, time_step); };
    const ContactSolution found = solve_contact(problem, falls, {5e6, 5e6}, problem.nothing());
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const double pull = 0.1 + 0.2 * i; // N
      EXPECT_NEAR(found.motion[i][1], pull < 6. ? 0. : (pull - 0.6) * compliance, 1e-15) << pull;
    }
  }
}
