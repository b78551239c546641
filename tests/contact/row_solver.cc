// SPDX-License-Identifier: LGPL-2.1-or-later

// The linear systems of Newton's method with every solver, against manufactured solutions: the
// right-hand sides follow from them by the problem's definition only.

#include "support/row_systems.h"

#include <numeric>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  /** Points on individual springs, each moved slightly by the next one's force, with a common rigid
   * motion; in blocks, with matrices for at most two of them. */
  class SpringBed : public ContactProblem, public BlockStructure
  {
  public:
    explicit SpringBed(const unsigned int size) : size(size) {}
    unsigned int n_points() const override { return size; }
    unsigned int n_rigid() const override { return 1; }
    std::vector<PointVector> relative_motion(const ContactState &state) const override
    {
      return motion_by(state);
    }
    std::vector<PointVector> motion_by(const ContactState &change) const override
    {
      std::vector<PointVector> motion(size);
      for (unsigned int i = 0; i < size; ++i)
      {
        motion[i] = change.force[i] + 0.2 * change.force[(i + 1) % size];
        motion[i][0] += 1e6 * change.rigid[0]; // units may differ
      }
      return motion;
    }
    void derivatives(const std::vector<unsigned int> &rows,
                     const std::vector<unsigned int> &columns,
                     dealii::FullMatrix<double> &matrix) const override
    {
      EXPECT_LE(std::max(rows.size(), columns.size()), of_block) << "too large for a matrix";
      matrix.reinit(3 * rows.size(), 3 * columns.size() + 1);
      for (unsigned int i = 0; i < rows.size(); ++i)
      {
        for (unsigned int j = 0; j < columns.size(); ++j)
          for (unsigned int c = 0; c < 3; ++c)
            matrix(3 * i + c, 3 * j + c) = rows[i] == columns[j]                ? 1.
                                           : (rows[i] + 1) % size == columns[j] ? 0.2
                                                                                : 0.;
        matrix(3 * i, 3 * columns.size()) = 1e6;
      }
    }
    const BlockStructure &structure() const override { return *this; }
    unsigned int n_blocks() const override { return size / of_block; }
    unsigned int block_of_point(const unsigned int point) const override
    {
      return point / of_block;
    }
    std::vector<double> balances(const ContactState &state) const override
    {
      double sum = 0.;
      for (const PointVector &force : state.force)
        sum += force[0];
      return {sum};
    }
    void balance_derivatives(const std::vector<unsigned int> &points,
                             dealii::FullMatrix<double> &matrix) const override
    {
      matrix.reinit(1, 3 * points.size() + 1);
      for (unsigned int i = 0; i < points.size(); ++i)
        matrix(0, 3 * i) = 1.;
    }

  private:
    static constexpr unsigned int of_block = 32;
    const unsigned int size;
  };

  /** Residual reduction of GMRES, with a margin for rounding. */
  constexpr double gmres = 1.5e-8;
} // namespace

TEST(RowSolver, SolvesSmallSystems)
{
  for (const unsigned int n_rigid : {0u, 1u, 3u})
  {
    const RandomProblem problem(30, 1, n_rigid);
    RowSolver solver;
    System(problem, all_but_some(30)).expect_solved_by(solver);
    System(problem, {4}).expect_solved_by(solver);
  }
}

TEST(RowSolver, SolvesRingsOfParts)
{
  for (const unsigned int n_parts : {4u, 9u})
    for (const unsigned int n_rigid : {n_parts, n_parts + 1}) // without and with a border
    {
      const RandomProblem problem(14 * n_parts, n_parts, n_rigid);
      RowSolver solver;
      System(problem, all_but_some(14 * n_parts)).expect_solved_by(solver);
    }
}

TEST(RowSolver, SolvesRingsOfPartsThatAreOpen)
{
  // A part to which the previous one contributes nothing, wherever the elimination begins.
  constexpr unsigned int n_parts = 4;
  for (unsigned int apart = 0; apart < n_parts; ++apart)
    for (const unsigned int n_rigid : {n_parts, n_parts + 1})
    {
      const RandomProblem problem(14 * n_parts, n_parts, n_rigid, 1., apart);
      RowSolver solver;
      System(problem, all_but_some(14 * n_parts)).expect_solved_by(solver);
    }
}

TEST(RowSolver, SolvesSystemsThatAreNearlyTheSameAndOthers)
{
  // Enough unknowns for cached factors in single precision.
  const unsigned int n = 400;
  const RandomProblem problem(n, 1, 2);
  RowSolver solver;
  System system(problem, all_but_some(n));
  system.expect_fulfilled_by(solver, gmres);
  for (const unsigned int n_changed : {1u, 5u, 340u, 1u, 1u})
  {
    system.change(n_changed);
    system.expect_fulfilled_by(solver, gmres);
  }
  System(problem, {1, 2, 3, 4, 5}).expect_solved_by(solver); // other nodes, and only a few
}

TEST(RowSolver, SolvesSystemsOfSlippingNodes)
{
  const unsigned int n = 200;
  const RandomProblem problem(n, 1, 2);
  for (const double little : {0., 1e-4, 1e-2, 1.})
  {
    RowSolver solver;
    System system(problem, all_but_some(n));
    for (unsigned int repetition = 0; repetition < 3; ++repetition) // also with cached factors
    {
      system.slip(little);
      system.expect_fulfilled_by(solver, gmres);
      system.choose(); // the same rows
      system.expect_fulfilled_by(solver, gmres);
    }
  }
}

TEST(SlipFactors, AreTheInverseButForRounding)
{
  for (const double rigid_unit : {1., 1e9})
  {
    const RandomProblem problem(120, 1, 2, rigid_unit);
    System system(problem, all_but_some(120), 1. / rigid_unit);
    system.slip(0.);
    const ContactRows rows(problem, system.touching, system.rows);
    const SlipFactors factors(rows);
    ASSERT_TRUE(factors.is_regular());
    EXPECT_TRUE(factors.fit(rows));
    // Each correction reduces the error only as far as single precision allows for an
    // ill-conditioned random system; four suffice if the factors are those of the rows.
    dealii::Vector<double> solution = factors.start(system.right_hand_side), residual(rows.size()),
                           correction(rows.size());
    for (unsigned int number = 0; number < 4; ++number)
    {
      rows.vmult(residual, solution);
      residual.sadd(-1., system.right_hand_side);
      factors.vmult(correction, residual);
      solution += correction;
    }
    solution -= system.chosen;
    for (unsigned int i = 0; i < rows.size(); ++i)
      EXPECT_LT(std::abs(solution[i]), 1e-9 * (i < rows.n_of_nodes() ? 1. : 1. / rigid_unit));
  }
}

TEST(SlipFactors, SayWhenTheyAreSingular)
{
  const RandomProblem problem(20, 1, 0);
  System system(problem, all_but_some(20));
  system.rows[3].by_motion = system.rows[3].by_force = dealii::Tensor<2, 3>();
  system.rows[3].has_friction                        = true;
  EXPECT_FALSE(SlipFactors(ContactRows(problem, system.touching, system.rows)).is_regular());
}

TEST(RowSolver, NeedsNoMatrixWhereItWouldBeTooLarge)
{
  const SpringBed problem(3200);
  std::vector<unsigned int> all;
  for (unsigned int i = 0; i < problem.n_points(); ++i)
    all.push_back(i);
  RowSolver solver;
  System(problem, all, 1e-6).expect_solved_by(solver, 1e-5);
}

TEST(RowSolver, SolvesBlocksThatAreNearlyTheSameAndOthers)
{
  const SpringBed problem(320);
  RowSolver solver;
  for (const unsigned int n_touching : {320u, 288u}) // factors of the first do not serve the other
  {
    std::vector<unsigned int> touching(n_touching);
    std::iota(touching.begin(), touching.end(), 0u);
    System system(problem, touching, 1e-6);
    system.expect_fulfilled_by(solver, gmres);
    for (const unsigned int n_changed : {1u, 5u, 200u, 1u, 1u})
    {
      system.change(n_changed);
      system.expect_fulfilled_by(solver, gmres);
    }
  }
}

TEST(RowSolver, SaysWhenASystemIsSingular)
{
  const RandomProblem problem(20, 1, 0);
  System system(problem, all_but_some(20));
  system.rows[3].by_motion = system.rows[3].by_force = dealii::Tensor<2, 3>();
  system.rows[3].has_friction                        = true;
  RowSolver solver;
  EXPECT_FALSE(solver.solve(problem, system.touching, system.rows, system.right_hand_side));
}
