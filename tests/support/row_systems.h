// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Random linear systems of Newton's method with manufactured solutions.

#include "support/dense_contact.h"

#include <ringmotor/contact/solve/row_solver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace ringmotor::tests
{
  inline std::mt19937 random_numbers(7);

  inline double random_number()
  {
    return std::uniform_real_distribution<double>(-1., 1.)(random_numbers);
  }

  /** A problem with random entries, whose contact nodes form a ring of parts of equal size, each of
   * which is moved by the previous one but for @p apart. If there are several parts, the last rigid
   * motion belongs to none of them. */
  class RandomProblem : public DenseContact, public BlockStructure
  {
  public:
    RandomProblem(const unsigned int n_points, const unsigned int n_parts,
                  const unsigned int n_rigid, const double rigid_unit = 1.,
                  const unsigned int apart = dealii::numbers::invalid_unsigned_int)
        : DenseContact(n_points, n_rigid), n_parts(n_parts)
    {
      for (unsigned int i = 0; i < 3 * n_points; ++i)
      {
        for (unsigned int j = 0; j < 3 * n_points; ++j)
        {
          const unsigned int p = part_of_point(i / 3), before = part_of_point(j / 3);
          if (p == before || (p == (before + 1) % n_parts && p != apart))
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

    const BlockStructure &structure() const override { return *this; }
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

    /** Perturbs the rows of some nodes. */
    void change(const unsigned int n_nodes)
    {
      for (unsigned int a = 0; a < n_nodes; ++a)
        rows[a].by_motion[0][0] += 0.5;
      choose();
    }

    /** Rows of slip along e as in Newton's method: motion along e enters none of them, or some of
     * them slightly. */
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
      chosen.reinit(3 * touching.size() + problem.n_rigid());
      for (unsigned int a = 0; a < touching.size(); ++a)
        for (unsigned int c = 0; c < (rows[a].has_friction ? 3 : 1); ++c)
          chosen[3 * a + c] = random_number();
      for (unsigned int r = 0; r < problem.n_rigid(); ++r)
        chosen[3 * touching.size() + r] = rigid_scale * random_number();
      right_hand_side = left_hand_side(chosen);
    }

    /** Computed from the problem's definition only. */
    dealii::Vector<double> left_hand_side(const dealii::Vector<double> &solution) const
    {
      const unsigned int n = 3 * touching.size(), n_rigid = problem.n_rigid();
      ContactState state{std::vector<PointVector>(problem.n_points()),
                         std::vector<double>(n_rigid)};
      for (unsigned int i = 0; i < n; ++i)
        state.force[touching[i / 3]][i % 3] = solution[i];
      for (unsigned int r = 0; r < n_rigid; ++r)
        state.rigid[r] = solution[n + r];
      dealii::Vector<double> left(n + n_rigid);
      const std::vector<PointVector> motion = problem.motion_by(state);
      for (unsigned int a = 0; a < touching.size(); ++a)
      {
        const PointVector result =
            rows[a].by_motion * motion[touching[a]] + rows[a].by_force * state.force[touching[a]];
        for (unsigned int c = 0; c < 3; ++c)
          left[3 * a + c] = result[c];
      }
      const std::vector<double> balances = problem.balances(state); // without loads
      for (unsigned int r = 0; r < n_rigid; ++r)
        left[n + r] = balances[r];
      return left;
    }

    void expect_solved_by(RowSolver &solver, const double tolerance = 1e-9) const
    {
      dealii::Vector<double> solution = right_hand_side;
      ASSERT_TRUE(solver.solve(problem, touching, rows, solution));
      solution -= chosen;
      EXPECT_LT(solution.linfty_norm(), tolerance);
    }

    /** The same for its residual, which an iterative solver controls whatever the condition number
     * of the random system. */
    void expect_fulfilled_by(RowSolver &solver, const double tolerance) const
    {
      dealii::Vector<double> solution = right_hand_side;
      ASSERT_TRUE(solver.solve(problem, touching, rows, solution));
      dealii::Vector<double> residual = left_hand_side(solution);
      residual -= right_hand_side;
      EXPECT_LT(residual.l2_norm(), tolerance * right_hand_side.l2_norm());
    }

    const ContactProblem &problem;
    const std::vector<unsigned int> touching;
    const double rigid_scale;
    std::vector<ContactRow> rows;
    dealii::Vector<double> chosen, right_hand_side;
  };

  inline std::vector<unsigned int> all_but_some(const unsigned int n_points)
  {
    std::vector<unsigned int> touching;
    for (unsigned int i = 0; i < n_points; ++i)
      if (i % 7 != 2)
        touching.push_back(i);
    return touching;
  }
} // namespace ringmotor::tests
