// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_solver.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ringmotor::tests
{
  /**
   * A contact problem given by dense matrices: motion = free_motion + compliance force +
   * rigid_motion rigid, and balance force + load = 0. Rows and columns 3 i, 3 i + 1 and 3 i + 2
   * belong to point i.
   */
  class DenseContact : public ContactProblem
  {
  public:
    DenseContact(const unsigned int n_points, const unsigned int n_rigid)
        : compliance(3 * n_points, 3 * n_points), free_motion(n_points), load(n_rigid),
          rigid_motion(3 * n_points, std::max(1u, n_rigid)),
          balance(std::max(1u, n_rigid), 3 * n_points)
    {
    }

    dealii::FullMatrix<double> compliance; ///< m/N
    std::vector<PointVector> free_motion;  ///< m
    std::vector<double> load;              ///< of the balances
    dealii::FullMatrix<double> rigid_motion, balance;

    unsigned int n_points() const override { return free_motion.size(); }
    unsigned int n_rigid() const override { return load.size(); }

    /** A state without forces and rigid motions. */
    ContactState nothing() const
    {
      return {std::vector<PointVector>(n_points()), std::vector<double>(n_rigid())};
    }

    std::vector<PointVector> relative_motion(const ContactState &state) const override
    {
      std::vector<PointVector> motion = motion_by(state);
      for (unsigned int i = 0; i < n_points(); ++i)
        motion[i] += free_motion[i];
      return motion;
    }

    std::vector<PointVector> motion_by(const ContactState &state) const override
    {
      std::vector<PointVector> motion(n_points());
      for (unsigned int row = 0; row < 3 * n_points(); ++row)
      {
        double sum = 0.;
        for (unsigned int j = 0; j < n_points(); ++j)
          for (unsigned int d = 0; d < 3; ++d)
            sum += compliance(row, 3 * j + d) * state.force[j][d];
        for (unsigned int r = 0; r < n_rigid(); ++r)
          sum += rigid_motion(row, r) * state.rigid[r];
        motion[row / 3][row % 3] += sum;
      }
      return motion;
    }

    void derivatives(const std::vector<unsigned int> &rows,
                     const std::vector<unsigned int> &columns,
                     dealii::FullMatrix<double> &matrix) const override
    {
      const unsigned int size = 3 * columns.size();
      matrix.reinit(3 * rows.size(), size + n_rigid());
      for (unsigned int row = 0; row < 3 * rows.size(); ++row)
      {
        const unsigned int from = 3 * rows[row / 3] + row % 3;
        for (unsigned int column = 0; column < size; ++column)
          matrix(row, column) = compliance(from, 3 * columns[column / 3] + column % 3);
        for (unsigned int r = 0; r < n_rigid(); ++r)
          matrix(row, size + r) = rigid_motion(from, r);
      }
    }

    std::vector<double> balances(const ContactState &state) const override
    {
      std::vector<double> sums = load;
      for (unsigned int r = 0; r < n_rigid(); ++r)
        for (unsigned int j = 0; j < n_points(); ++j)
          for (unsigned int d = 0; d < 3; ++d)
            sums[r] += balance(r, 3 * j + d) * state.force[j][d];
      return sums;
    }

    void balance_derivatives(const std::vector<unsigned int> &points,
                             dealii::FullMatrix<double> &matrix) const override
    {
      const unsigned int size = 3 * points.size();
      matrix.reinit(n_rigid(), size + n_rigid());
      for (unsigned int r = 0; r < n_rigid(); ++r)
        for (unsigned int column = 0; column < size; ++column)
          matrix(r, column) = balance(r, 3 * points[column / 3] + column % 3);
    }
  };

  /** Coulomb's law with one coefficient. */
  inline PointFriction coulomb(const double mu)
  {
    return [mu](const unsigned int, const double) { return FrictionCoefficient{mu, 0.}; };
  }

  /** The sum of a component of the forces, N. */
  inline double total(const ContactState &state, const unsigned int component)
  {
    double sum = 0.;
    for (const PointVector &force : state.force)
      sum += force[component];
    return sum;
  }

  inline unsigned int count(const ContactSolution &solution, const PointStatus status)
  {
    return std::count(solution.status.begin(), solution.status.end(), status);
  }
} // namespace ringmotor::tests
