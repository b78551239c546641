// SPDX-License-Identifier: LGPL-2.1-or-later

// The linear systems of Newton's method in every way in which they are solved, against solutions
// that were chosen first: from them follow the right-hand sides, by the laws of the problem alone.

#include "support/dense_contact.h"

#include <ringmotor/contact/chain_of_blocks.h>
#include <ringmotor/contact/row_solver.h>
#include <ringmotor/contact/slip_factors.h>

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  std::mt19937 random_numbers(7);

  double random_number()
  {
    return std::uniform_real_distribution<double>(-1., 1.)(random_numbers);
  }

  /** A problem of random entries, whose points fall into parts of equal size in a ring. The last
   * rigid motion belongs to none of several parts. */
  class RandomProblem : public DenseContact
  {
  public:
    RandomProblem(const unsigned int n_points, const unsigned int n_parts,
                  const unsigned int n_rigid, const double rigid_unit = 1.)
        : DenseContact(n_points, n_rigid), n_parts(n_parts)
    {
      for (unsigned int i = 0; i < 3 * n_points; ++i)
      {
        for (unsigned int j = 0; j < 3 * n_points; ++j)
        {
          const unsigned int p = part_of_point(i / 3), before = part_of_point(j / 3);
          if (p == before || p == (before + 1) % n_parts)
            compliance(i, j) = 2. * (i == j) + random_number() / n_points;
        }
        for (unsigned int r = 0; r < n_rigid; ++r)
          if (part_of_rigid(r) == no_part || part_of_rigid(r) == part_of_point(i / 3))
          {
            rigid_motion(i, r) = rigid_unit * (1. + 0.2 * random_number());
            balance(r, i)      = 1. + 0.2 * random_number();
          }
      }
    }

    unsigned int part_of_point(const unsigned int point) const override
    {
      return point * n_parts / n_points();
    }
    unsigned int part_of_rigid(const unsigned int motion) const override
    {
      return motion < n_parts ? motion : no_part;
    }

  private:
    const unsigned int n_parts;
  };

  /** A system for a problem, and its solution. */
  struct System
  {
    System(const ContactProblem &problem, const std::vector<unsigned int> &touching,
           const double rigid_scale = 1.)
        : problem(problem), touching(touching), rigid_scale(rigid_scale), rows(touching.size())
    {
      for (unsigned int a = 0; a < rows.size(); ++a)
      {
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int d = 0; d < 3; ++d)
          {
            rows[a].by_motion[c][d] = (c == d) + 0.2 * random_number();
            rows[a].by_force[c][d]  = 0.1 * random_number();
          }
        if (a % 5 == 3) // without friction: forces along the surface are zero and stay zero
        {
          rows[a].has_friction = false;
          for (unsigned int c = 1; c < 3; ++c)
            rows[a].by_motion[c] = rows[a].by_force[c] = dealii::Tensor<1, 3>();
        }
      }
      choose();
    }

    /** Turns the rows of some nodes a little. */
    void change(const unsigned int n_nodes)
    {
      for (unsigned int a = 0; a < n_nodes; ++a)
        rows[a].by_motion[0][0] += 0.5;
      choose();
    }

    /** Rows of slip along e as Newton's method has them: motion along e is in none of them, or in
     * some of them a little. */
    void slip(const double little)
    {
      constexpr double mu = 0.4, ratio = 0.7;
      for (unsigned int a = 0; a < rows.size(); ++a)
      {
        if (a % 5 > 2) // some stick, some are without friction
          continue;
        const double angle = M_PI * random_number(), e[] = {std::cos(angle), std::sin(angle)};
        ContactRow row;
        row.by_motion[0][0] = 1.;
        for (unsigned int c = 0; c < 2; ++c)
        {
          for (unsigned int d = 0; d < 2; ++d)
          {
            row.by_motion[1 + c][1 + d] =
                ratio * ((c == d) - (a % 3 == 0 ? 1. - little : 1.) * e[c] * e[d]);
            row.by_force[1 + c][1 + d] = (c == d) - row.by_motion[1 + c][1 + d];
          }
          row.by_force[1 + c][0] = -mu * e[c];
        }
        rows[a] = row;
      }
      choose();
    }

    void choose()
    {
      const unsigned int n = 3 * touching.size(), n_rigid = problem.n_rigid();
      chosen.reinit(n + n_rigid);
      right_hand_side.reinit(chosen.size());
      ContactState state{std::vector<PointVector>(problem.n_points()),
                         std::vector<double>(n_rigid)};
      for (unsigned int a = 0; a < touching.size(); ++a)
        for (unsigned int c = 0; c < (rows[a].has_friction ? 3 : 1); ++c)
          chosen[3 * a + c] = state.force[touching[a]][c] = random_number();
      for (unsigned int r = 0; r < n_rigid; ++r)
        chosen[n + r] = state.rigid[r] = rigid_scale * random_number();
      const std::vector<PointVector> motion = problem.motion_by(state);
      for (unsigned int a = 0; a < touching.size(); ++a)
      {
        const PointVector result =
            rows[a].by_motion * motion[touching[a]] + rows[a].by_force * state.force[touching[a]];
        for (unsigned int c = 0; c < 3; ++c)
          right_hand_side[3 * a + c] = result[c];
      }
      const std::vector<double> balances = problem.balances(state); // without loads
      for (unsigned int r = 0; r < n_rigid; ++r)
        right_hand_side[n + r] = balances[r];
    }

    void expect_solved_by(RowSolver &solver, const double tolerance = 1e-9) const
    {
      dealii::Vector<double> solution = right_hand_side;
      ASSERT_TRUE(solver.solve(problem, touching, rows, solution));
      solution -= chosen;
      EXPECT_LT(solution.linfty_norm(), tolerance);
    }

    const ContactProblem &problem;
    const std::vector<unsigned int> touching;
    const double rigid_scale;
    std::vector<ContactRow> rows;
    dealii::Vector<double> chosen, right_hand_side;
  };

  std::vector<unsigned int> all_but_some(const unsigned int n_points)
  {
    std::vector<unsigned int> touching;
    for (unsigned int i = 0; i < n_points; ++i)
      if (i % 7 != 2)
        touching.push_back(i);
    return touching;
  }

  /** Points on springs of their own, each moved a little by the next one's force, with a rigid
   * motion of all; blocks of points, and matrices of two of them at most. */
  class SpringBed : public ContactProblem
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
        motion[i][0] += 1e6 * change.rigid[0]; // units need not be alike
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

  /** Blocks of points on a ring that know of each other through far shapes only. In the steady
   * state slips are measured from where the block before is. */
  class RingOfBlocks : public DenseContact
  {
  public:
    RingOfBlocks(const unsigned int n_blocks, const bool is_steady)
        : DenseContact(n_blocks * of_block, 2), is_steady(is_steady), blocks(n_blocks)
    {
      const unsigned int n = 3 * n_points();
      for (unsigned int a = 0; a < 3 * of_block; ++a)
        for (unsigned int s = 0; s < n_far; ++s)
          shapes[a][s] = random_number();
      for (unsigned int moved = 0; moved < n_blocks; ++moved)
        for (unsigned int loaded = 0; loaded < n_blocks; ++loaded)
          kernels.push_back(random_kernel());
      dealii::FullMatrix<double> positions(n, n), rise(n, 2);
      for (unsigned int i = 0; i < n; ++i)
      {
        rise(i, 0) = 1. + 0.2 * random_number();
        rise(i, 1) = random_number();
        for (unsigned int j = 0; j < n; ++j)
        {
          const unsigned int moved = i / (3 * of_block), loaded = j / (3 * of_block);
          if (moved == loaded)
            positions(i, j) = 2. * (i == j) + 0.1 * random_number();
          else
            for (unsigned int s = 0; s < n_far; ++s)
              for (unsigned int t = 0; t < n_far; ++t)
                positions(i, j) += shape(i, s) * (*far_kernel(moved, loaded))(s, t) * shape(j, t);
        }
      }
      for (unsigned int i = 0; i < n; ++i)
      {
        const bool is_slip        = is_steady && i % 3 > 0;
        const unsigned int before = (i + n - 3 * of_block) % n;
        for (unsigned int j = 0; j < n; ++j)
          compliance(i, j) = positions(i, j) - (is_slip ? positions(before, j) : 0.);
        for (unsigned int r = 0; r < 2; ++r)
        {
          rigid_motion(i, r) = rise(i, r) - (is_slip ? rise(before, r) : 0.);
          balance(r, i)      = rise(i, r);
        }
      }
    }

    unsigned int n_blocks() const override { return blocks; }
    unsigned int block_of_point(const unsigned int point) const override
    {
      return point / of_block;
    }
    unsigned int block_before(const unsigned int block) const override
    {
      return is_steady ? (block + blocks - 1) % blocks : no_part;
    }
    unsigned int n_far_shapes() const override { return n_far; }
    double far_shape(const unsigned int point, const unsigned int component,
                     const unsigned int shape) const override
    {
      return shapes[3 * (point % of_block) + component][shape];
    }
    const dealii::FullMatrix<double> *far_kernel(const unsigned int moved,
                                                 const unsigned int loaded) const override
    {
      return moved == loaded ? nullptr : &kernels[moved * blocks + loaded];
    }

  private:
    static constexpr unsigned int of_block = 4, n_far = 3;

    double shape(const unsigned int row, const unsigned int which) const
    {
      return far_shape(row / 3, row % 3, which);
    }
    static dealii::FullMatrix<double> random_kernel()
    {
      dealii::FullMatrix<double> kernel(n_far, n_far);
      for (unsigned int s = 0; s < n_far; ++s)
        for (unsigned int t = 0; t < n_far; ++t)
          kernel(s, t) = 0.02 * random_number();
      return kernel;
    }

    const bool is_steady;
    const unsigned int blocks;
    double shapes[3 * of_block][n_far];
    std::vector<dealii::FullMatrix<double>> kernels;
  };
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

TEST(RowSolver, SolvesSystemsThatAreNearlyTheSameAndOthers)
{
  // Enough unknowns for kept factors in single precision. GMRES reduces residuals by 1e-8, which is
  // less than a hundredth of these solutions; Newton's next step does the rest.
  const unsigned int n = 400;
  const RandomProblem problem(n, 1, 2);
  RowSolver solver;
  System system(problem, all_but_some(n));
  system.expect_solved_by(solver, 1e-2);
  for (const unsigned int n_changed : {1u, 5u, 340u, 1u, 1u})
  {
    system.change(n_changed);
    system.expect_solved_by(solver, 1e-2);
  }
  System(problem, {1, 2, 3, 4, 5}).expect_solved_by(solver); // other nodes, and few
}

TEST(RowSolver, SolvesSystemsOfSlippingNodes)
{
  const unsigned int n = 200;
  const RandomProblem problem(n, 1, 2);
  for (const double little : {0., 1e-4, 1e-2, 1.})
  {
    RowSolver solver;
    System system(problem, all_but_some(n));
    for (unsigned int repetition = 0; repetition < 3; ++repetition) // with kept factors, too
    {
      system.slip(little);
      system.expect_solved_by(solver, 1e-2); // see above
      system.choose();                       // the same rows
      system.expect_solved_by(solver, 1e-2); // see above
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
    dealii::Vector<double> solution = factors.start(system.right_hand_side), residual(rows.size()),
                           rest(rows.size());
    rows.vmult(residual, solution);
    residual.sadd(-1., system.right_hand_side);
    factors.vmult(rest, residual);
    solution += rest;
    solution -= system.chosen;
    for (unsigned int i = 0; i < rows.size(); ++i) // single precision, random condition
      EXPECT_LT(std::abs(solution[i]), 1e-2 * (i < rows.n_of_nodes() ? 1. : 1. / rigid_unit));
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

TEST(ChainOfBlocks, IsTheInverseWhereBlocksKnowFarShapesOnly)
{
  for (const bool is_steady : {false, true})
    for (const bool is_whole : {false, true})
    {
      // The whole ring, whose chain has to be cut, and one in which a block does not touch.
      const RingOfBlocks problem(9, is_steady);
      std::vector<unsigned int> touching;
      for (unsigned int i = 0; i < problem.n_points(); ++i)
        if (is_whole || (i % 7 != 2 && problem.block_of_point(i) != 5))
          touching.push_back(i);
      const System system(problem, touching);
      const ContactRows rows(problem, touching, system.rows);
      const ChainOfBlocks chain(rows);
      ASSERT_TRUE(chain.is_regular());
      dealii::Vector<double> solution(rows.size());
      chain.vmult(solution, system.right_hand_side);
      for (const unsigned int i : rows.unknowns())
        EXPECT_NEAR(solution[i], system.chosen[i], 1e-9) << is_steady << is_whole << " " << i;
    }
}

TEST(ChainOfBlocks, SaysWhenABlockIsSingular)
{
  const RingOfBlocks problem(4, false);
  System system(problem, all_but_some(problem.n_points()));
  system.rows[3].by_motion = system.rows[3].by_force = dealii::Tensor<2, 3>();
  system.rows[3].has_friction                        = true;
  const ContactRows rows(problem, system.touching, system.rows);
  EXPECT_FALSE(ChainOfBlocks(rows).is_regular());
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
