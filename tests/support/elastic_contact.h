// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "support/dense_contact.h"
#include "support/two_blocks.h"

#include <numeric>

namespace ringmotor::tests
{
  /** An upper body in contact with a lower one, both elastic, from a state of rest. */
  class ElasticContact : public DenseContact
  {
  public:
    /** @p preload in N presses the upper body down, which is then free to rise; without it the
     * motion without contact forces determines the positions of the bodies. */
    ElasticContact(const CondensedBlock &lower, const CondensedBlock &upper,
                   const std::optional<double> &preload = {})
        : ElasticContact(lower, upper, preload,
                         couple(lower.surface(), upper.surface(), 2. * dealii::numbers::PI))
    {
    }

    ContactSolution solve(const double friction_coefficient) const
    {
      const ComplementarityConstants constants{1. / compliance(0, 0), 1. / compliance(1, 1)};
      ContactState start = nothing();
      // A free upper body starts so low that all contact nodes touch.
      for (unsigned int i = 0; n_rigid() > 0 && i < n_points(); ++i)
        start.rigid[0] = std::min(start.rigid[0], -2. * free_motion[i][0]);
      return solve_contact(*this, coulomb(friction_coefficient), constants, start);
    }

    const MortarCoupling coupling;
    dealii::FullMatrix<double> of_lower; ///< compliance of the lower body, m/N

  private:
    ElasticContact(const CondensedBlock &lower, const CondensedBlock &upper,
                   const std::optional<double> &preload, const MortarCoupling &coupling)
        : DenseContact(coupling.nodes.size(), preload ? 1 : 0), coupling(coupling),
          of_lower(3 * n_points(), 3 * n_points())
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
      if (!preload)
        return;
      load[0] = -*preload;
      for (unsigned int i = 0; i < n_points(); ++i)
        rigid_motion(3 * i, 0) = balance(0, 3 * i) = 1.;
    }

    unsigned int index_of_lower(const unsigned int i) const
    {
      return 3 * coupling.nodes[i / 3].tooth_node + i % 3;
    }
  };
} // namespace ringmotor::tests
