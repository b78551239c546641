// SPDX-License-Identifier: LGPL-2.1-or-later

// Cases where an active-set method may fail: no friction and high friction, contact nodes that all
// touch or open together, strongly coupled normal and tangential motions, bad constants, initial
// states that constrain no rigid motion, problems without a solution. Solutions are known, or are
// checked against the laws themselves; problems without a solution must be refused.

#include "support/contact_laws.h"
#include "support/half_planes.h"
#include "support/random_contact.h"

#include <ringmotor/contact/solve/contact_newton.h>
#include <ringmotor/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  // mm, N, MPa
  constexpr HalfPlanes steel{82000., 0.28, 82000., 0.28},
      aluminium_on_steel{23000., 0.31, 82000., 0.28};

  LineContact cylinders(const HalfPlanes &bodies)
  {
    return {bodies, 500., -1.1, 0.04, 56};
  }

  constexpr double load = 180.;

  /** Without the rigid motions other than the first, and their loads. */
  DenseContact held(const DenseContact &free)
  {
    DenseContact problem(free.n_points(), 1);
    problem.compliance  = free.compliance;
    problem.free_motion = free.free_motion;
    problem.load[0]     = free.load[0];
    for (unsigned int row = 0; row < 3 * free.n_points(); ++row)
    {
      problem.rigid_motion(row, 0) = free.rigid_motion(row, 0);
      problem.balance(0, row)      = free.balance(0, row);
    }
    return problem;
  }

  void expect_refused(const DenseContact &problem, const double mu,
                      const ComplementarityConstants &constants)
  {
    EXPECT_THROW(solve_contact(problem, coulomb(mu), constants, problem.nothing()),
                 ComputationError);
  }

} // namespace

TEST(ContactHard, WithoutFriction)
{
  for (const HalfPlanes &bodies : {steel, aluminium_on_steel})
  {
    const LineContact line      = cylinders(bodies);
    const DenseContact problem  = held(line.shift(load, 0.));
    const ContactSolution found = expect_solved(problem, 0., line.constants(), problem.nothing());
    for (const PointVector &force : found.state.force)
      EXPECT_EQ(std::hypot(force[1], force[2]), 0.);
    EXPECT_EQ(count(found, PointStatus::stick), 0u);
  }
}

TEST(ContactHard, WithoutFrictionAndFreeToMove)
{
  // Nothing balances a tangential force; without one the rigid motion is arbitrary, and some
  // solution is found.
  const LineContact line = cylinders(steel);
  expect_refused(line.shift(load, 1.), 0., line.constants());
  const DenseContact unloaded = line.shift(load, 0.);
  expect_solved(unloaded, 0., line.constants(), unloaded.nothing());
}

TEST(ContactHard, WithMuchFriction)
{
  for (const HalfPlanes &bodies : {steel, aluminium_on_steel})
    for (const double part : {0., 0.1, 0.5, 0.9})
    {
      const LineContact line     = cylinders(bodies);
      const DenseContact problem = line.shift(load, -5. * part * load);
      expect_solved(problem, 5., line.constants(), problem.nothing());
    }
}

TEST(ContactHard, WithMoreThanFrictionBears)
{
  for (const HalfPlanes &bodies : {steel, aluminium_on_steel})
    for (const double mu : {0.01, 0.3, 1.})
      for (const double part : {1.001, 2.})
      {
        const LineContact line = cylinders(bodies);
        expect_refused(line.shift(load, part * mu * load), mu, line.constants());
      }
}

TEST(ContactHard, FromEverywhere)
{
  const LineContact line         = cylinders(aluminium_on_steel);
  const DenseContact problem     = line.rolling(load, -0.2 * load);
  const ContactSolution expected = expect_solved(problem, 0.3, line.constants(), problem.nothing());
  for (const double approach : {-1., 0., 1e-3, 0.1, 1e3})
    for (const double creep : {-1., -1e-3, 0., 1e-4, 1.})
      for (const double pressure : {0., 1., 1e4})
      {
        ContactState start = problem.nothing();
        start.rigid        = {approach, creep};
        for (PointVector &force : start.force)
          force[0] = force[1] = pressure;
        const ContactSolution found = expect_solved(problem, 0.3, line.constants(), start);
        EXPECT_NEAR(found.state.rigid[1] / expected.state.rigid[1], 1., 1e-9)
            << approach << " " << creep << " " << pressure;
      }
}

TEST(ContactHard, OfNothing)
{
  // No contact node touches, or there is none.
  DenseContact apart(3, 0);
  for (unsigned int i = 0; i < 9; ++i)
    apart.compliance(i, i) = 1e-8;
  for (PointVector &motion : apart.free_motion)
    motion[0] = 1e-6;
  ContactState pressed = apart.nothing();
  for (PointVector &force : pressed.force)
    force[0] = force[1] = 1.;
  for (const ContactState &start : {apart.nothing(), pressed})
    EXPECT_EQ(count(expect_solved(apart, 0.3, {1e8, 1e8}, start), PointStatus::open), 3u);
  const DenseContact nowhere(0, 0);
  EXPECT_TRUE(solve_contact(nowhere, coulomb(0.3), {1., 1.}, nowhere.nothing()).status.empty());
  // An unconstrained rigid motion
  DenseContact adrift(3, 1);
  expect_refused(adrift, 0.3, {1e8, 1e8});
}

TEST(ContactHard, ThatIsGivenUpIsNotSolved)
{
  DenseContact problem(3, 0);
  for (unsigned int i = 0; i < 9; ++i)
    problem.compliance(i, i) = 1e-8;
  for (PointVector &motion : problem.free_motion)
    motion[0] = -1e-6;
  const FrictionBoundOf without = [](unsigned int, double, double) { return FrictionBound{}; };
  for (const unsigned int most_touching : {2u, 3u})
  {
    RowSolver solver;
    NewtonLimits limits{20};
    limits.most_touching = most_touching;
    const ContactIterate iterate =
        newton(problem, without, {1e8, 1e8}, problem.nothing(), limits, solver);
    EXPECT_EQ(iterate.certified(), most_touching == 3);
  }
}

TEST(ContactHard, ThatAllGrazes)
{
  // All gaps are zero, exactly and up to rounding, first without a load
  const ComplementarityConstants constants = cylinders(steel).constants();
  const DenseContact pressed               = held(cylinders(steel).shift(load, 0.));
  for (const double noise : {0., 1e-17})
    for (const double slip : {0., 1e-6})
    {
      DenseContact problem(pressed.n_points(), 0);
      problem.compliance = pressed.compliance;
      for (PointVector &motion : problem.free_motion)
      {
        motion[0] = random(-noise, noise);
        motion[1] = slip;
      }
      const ContactSolution found =
          solve_contact(problem, coulomb(0.3), constants, problem.nothing());
      for (const PointVector &force : found.state.force)
        EXPECT_LT(force.norm(), 1e-9);

      DenseContact punch = pressed;
      punch.free_motion  = problem.free_motion;
      expect_solved(punch, 0.3, constants, punch.nothing());
    }
}

TEST(ContactHard, OfRigidFaces)
{
  // Three points of a rigid block on springs for friction; its weight is shared evenly. The rigid
  // motions are up and two tilts; it is dragged.
  DenseContact problem(3, 3);
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double x[3] = {1., std::cos(2. * M_PI * i / 3.), std::sin(2. * M_PI * i / 3.)};
    for (unsigned int r = 0; r < 3; ++r)
      problem.rigid_motion(3 * i, r) = problem.balance(r, 3 * i) = x[r];
    for (const unsigned int c : {1u, 2u})
      problem.compliance(3 * i + c, 3 * i + c) = 1e-8;
    problem.free_motion[i][0] = 1e-4 * i;
    problem.free_motion[i][1] = 1e-6;
  }
  problem.load                = {-3., 0., 0.};
  const ContactSolution found = solve_contact(problem, coulomb(0.4), {1e8, 1e8}, problem.nothing());
  for (const PointVector &force : found.state.force)
  {
    EXPECT_NEAR(force[0], 1., 1e-9);
    EXPECT_NEAR(force[1], -0.4, 1e-9);
  }
}

TEST(ContactHard, OfTwinPoints)
{
  // Two coincident contact nodes: only the sum of their pressures is determined
  DenseContact problem(2, 0);
  for (unsigned int i = 0; i < 6; ++i)
    for (const unsigned int j : {i % 3, i % 3 + 3})
      problem.compliance(i, j) = 1e-8;
  for (PointVector &motion : problem.free_motion)
    motion[0] = -1e-6;
  const ContactSolution found = expect_solved(problem, 0.3, {1e8, 1e8}, problem.nothing());
  EXPECT_NEAR(total(found.state, 0), 100., 1e-5);
}

TEST(ContactHard, OfNoNumbers)
{
  const LineContact line     = cylinders(steel);
  const DenseContact problem = line.shift(load, 0.1 * load);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    for (const unsigned int c : {0u, 1u, 2u})
    {
      DenseContact wrong       = problem;
      wrong.free_motion[20][c] = bad;
      expect_refused(wrong, 0.3, line.constants());
    }
  }
  ContactState start = problem.nothing();
  start.force[10][0] = start.rigid[1] = std::numeric_limits<double>::quiet_NaN();
  expect_solved(problem, 0.3, line.constants(), start);
}

TEST(ContactHard, RollingWithHardlyAnyFriction)
{
  // Nearly all strips slip, and one or two sticking strips determine the creep.
  for (const double place : {0., 0.25, 0.5})
    for (const double mu : {1e-5, 1e-4, 1e-3, 1e-2})
      for (const double part : {-0.9, -0.5, -0.1, 0., 0.1, 0.5, 0.9})
      {
        LineContact line = cylinders(aluminium_on_steel);
        line.first += place * line.width;
        const DenseContact problem = line.rolling(0.5 * load, 0.5 * part * mu * load);
        expect_solved(problem, mu, line.constants(), problem.nothing());
      }
}

TEST(ContactHard, HasItsErrorsSeen)
{
  const LineContact line      = cylinders(aluminium_on_steel);
  const DenseContact problem  = line.shift(load, -0.2 * load);
  const ContactSolution found = expect_solved(problem, 0.3, line.constants(), problem.nothing());
  const FrictionBoundOf bound = [](const unsigned int, const double pressure, const double) {
    return FrictionBound{0.3 * pressure, 0.3, 0.};
  };
  const auto certificate_with = [&](const auto &change)
  {
    ContactState state = found.state;
    change(state);
    return certify(problem, bound, state, problem.relative_motion(state));
  };
  const unsigned int middle = line.n_strips / 2;
  const double small        = 1e-5 * load;
  EXPECT_TRUE(certificate_with([](ContactState &) {}).holds());
  EXPECT_GT(certificate_with([&](ContactState &s) { s.force[0][0] = -small; }).tension, 1e-5);
  EXPECT_GT(certificate_with([&](ContactState &s) { s.rigid[0] += 1e-8; }).penetration, 1e-7);
  EXPECT_GT(certificate_with([&](ContactState &s) { s.rigid[0] -= 1e-8; }).complementarity, 1e-7);
  EXPECT_GT(certificate_with([&](ContactState &s) { s.force[middle][1] = load; }).friction_excess,
            1e-5);
  EXPECT_GT(certificate_with([&](ContactState &s) { s.rigid[1] += 1e-8; }).friction_defect, 1e-7);
  EXPECT_GT(certificate_with([&](ContactState &s) { s.force[middle][0] += small; }).balance, 1e-6);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (unsigned int c = 0; c < 3; ++c)
    EXPECT_FALSE(certificate_with([&](ContactState &s) { s.force[middle][c] = nan; }).holds());
  for (const unsigned int r : {0u, 1u})
    EXPECT_FALSE(certificate_with([&](ContactState &s) { s.rigid[r] = nan; }).holds());
}
