// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "support/two_blocks.h"

#include <numeric>

namespace ringmotor::tests
{
  /** An upper body in contact with a lower one, both elastic, from a state of rest. */
  class ElasticContact : public ContactProblem
  {
  public:
    /** @p preload in N presses the upper body down, which then can rise; without it the motion
     * without contact forces tells where the bodies are. */
    ElasticContact(const CondensedBlock &lower, const CondensedBlock &upper,
                   const std::optional<double> &preload = {})
        : preload(preload),
          coupling(couple(lower.surface(), upper.surface(), 2. * dealii::numbers::PI)),
          free_motion(coupling.nodes.size()), of_lower(3 * n_points(), 3 * n_points()),
          compliance(of_lower)
    {
      const RingCompliance of_upper(1, upper.compliance, coupling, {});
      std::vector<unsigned int> all(n_points());
      std::iota(all.begin(), all.end(), 0u);
      of_upper.add_entries(0, all, all, 1., 0, compliance, 0, 0);
      for (unsigned int i = 0; i < 3 * n_points(); ++i)
        for (unsigned int j = 0; j < 3 * n_points(); ++j)
        {
          of_lower(i, j) = lower.compliance.at_rest(index_of_lower(i), index_of_lower(j));
          compliance(i, j) += of_lower(i, j);
        }
      for (unsigned int i = 0; i < 3 * n_points(); ++i)
      {
        double &motion = free_motion[i / 3][i % 3];
        motion         = -lower.by_side_load[index_of_lower(i)];
        for (const MortarCoupling::Weight &share : coupling.nodes[i / 3].weights)
          motion += share.weight * upper.by_side_load[3 * share.rotor_node + i % 3];
      }
    }

    unsigned int n_points() const override { return coupling.nodes.size(); }
    unsigned int n_rigid() const override { return preload ? 1 : 0; }

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
      for (unsigned int i = 0; i < 3 * n_points(); ++i)
      {
        motion[i / 3][i % 3] += preload && i % 3 == 0 ? state.rigid[0] : 0.;
        for (unsigned int j = 0; j < 3 * n_points(); ++j)
          motion[i / 3][i % 3] += compliance(i, j) * state.force[j / 3][j % 3];
      }
      return motion;
    }

    void derivatives(const std::vector<unsigned int> &rows,
                     const std::vector<unsigned int> &columns,
                     dealii::FullMatrix<double> &matrix) const override
    {
      const unsigned int n = 3 * columns.size();
      matrix.reinit(3 * rows.size(), n + n_rigid());
      for (unsigned int i = 0; i < 3 * rows.size(); ++i)
      {
        for (unsigned int j = 0; j < n; ++j)
          matrix(i, j) = compliance(3 * rows[i / 3] + i % 3, 3 * columns[j / 3] + j % 3);
        if (preload && i % 3 == 0)
          matrix(i, n) = 1.;
      }
    }

    std::vector<double> balances(const ContactState &state) const override
    {
      if (!preload)
        return {};
      double sum = -*preload;
      for (const PointVector &force : state.force)
        sum += force[0];
      return {sum};
    }

    void balance_derivatives(const std::vector<unsigned int> &points,
                             dealii::FullMatrix<double> &matrix) const override
    {
      matrix.reinit(n_rigid(), 3 * points.size() + n_rigid());
      for (unsigned int i = 0; preload && i < points.size(); ++i)
        matrix(0, 3 * i) = 1.;
    }

    ContactSolution solve(const double friction_coefficient) const
    {
      const ComplementarityConstants constants{1. / compliance(0, 0), 1. / compliance(1, 1)};
      ContactState start{std::vector<PointVector>(n_points()), std::vector<double>(n_rigid(), 0.)};
      // An upper body that floats starts so low that all points touch.
      for (unsigned int i = 0; preload && i < n_points(); ++i)
        start.rigid[0] = std::min(start.rigid[0], -2. * free_motion[i][0]);
      return solve_contact(
          *this,
          [&](unsigned int, double) {
            return FrictionCoefficient{friction_coefficient, 0.};
          },
          constants, start);
    }

    const std::optional<double> preload;
    const MortarCoupling coupling;
    std::vector<PointVector> free_motion; ///< m, without contact forces
    dealii::FullMatrix<double> of_lower;  ///< compliance of the lower body
    dealii::FullMatrix<double> compliance;

  private:
    unsigned int index_of_lower(const unsigned int i) const
    {
      return 3 * coupling.nodes[i / 3].tooth_node + i % 3;
    }
  };
} // namespace ringmotor::tests
