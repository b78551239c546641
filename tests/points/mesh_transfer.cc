// SPDX-License-Identifier: LGPL-2.1-or-later

// States carried from one interface mesh to another: no force may be lost, and contact nodes behind
// the touching edge stay open.

#include <ringmotor/points/mesh_transfer.h>

#include <gtest/gtest.h>

#include <vector>

using namespace ringmotor;

namespace
{
  /** A tooth's contact nodes in rows of equal radius. */
  CondensedMotor grid(const std::vector<double> &radii, const std::vector<double> &angles)
  {
    CondensedMotor motor;
    motor.degree              = 1;
    const unsigned int n_rows = radii.size(), n_columns = angles.size();
    for (const double radius : radii)
      for (const double angle : angles)
        motor.nodes.push_back({radius, angle, 1.});
    for (unsigned int i = 0; i + 1 < n_rows; ++i)
      for (unsigned int j = 0; j + 1 < n_columns; ++j)
      {
        const unsigned int first = i * n_columns + j, above = first + n_columns;
        motor.faces.push_back({first, above, first + 1, above + 1});
      }
    return motor;
  }

  const CondensedMotor coarse = grid({1., 2.}, {0., 0.1, 0.2}),
                       fine   = grid({1., 1.4, 2.}, {0., 0.05, 0.1, 0.15, 0.2});

  /** Two teeth that touch on the inner row only, with different forces. */
  ContactFields edge_contact()
  {
    ContactFields fields;
    fields.times             = {0.};
    fields.n_repeating_teeth = 2;
    for (unsigned int tooth = 0; tooth < 2; ++tooth)
      for (unsigned int node = 0; node < 6; ++node)
      {
        PointVector force, motion;
        if (node < 3)
        {
          force[0]  = 1. + node + tooth;
          force[1]  = -0.4 * force[0];
          motion[1] = 1e-7;
        }
        else
          motion[0] = 1e-6;
        fields.state.force.push_back(force);
        fields.motion.push_back(motion);
        fields.status.push_back(node < 3 ? PointStatus::slip : PointStatus::open);
      }
    return fields;
  }

  PointVector sum_of_tooth(const std::vector<PointVector> &forces, const unsigned int tooth)
  {
    PointVector sum;
    for (unsigned int i = tooth * forces.size() / 2; i < (tooth + 1) * forces.size() / 2; ++i)
      sum += forces[i];
    return sum;
  }
} // namespace

TEST(MeshTransfer, ChangesNothingOnTheSameMesh)
{
  const ContactFields fields = edge_contact(), same = MeshTransfer(coarse, coarse).fields(fields);
  ASSERT_EQ(same.state.force.size(), fields.state.force.size());
  for (unsigned int i = 0; i < fields.state.force.size(); ++i)
  {
    EXPECT_LT((same.state.force[i] - fields.state.force[i]).norm(), 1e-14);
    EXPECT_LT((same.motion[i] - fields.motion[i]).norm(), 1e-20);
    EXPECT_EQ(same.status[i], fields.status[i]);
  }
}

TEST(MeshTransfer, LosesNoForceAndKeepsTheEdge)
{
  const ContactFields fields = edge_contact(), finer = MeshTransfer(coarse, fine).fields(fields),
                      back = MeshTransfer(fine, coarse).fields(finer);
  ASSERT_EQ(finer.state.force.size(), 30u);
  for (unsigned int tooth = 0; tooth < 2; ++tooth)
  {
    const PointVector sum = sum_of_tooth(fields.state.force, tooth);
    EXPECT_LT((sum_of_tooth(finer.state.force, tooth) - sum).norm(), 1e-13);
    EXPECT_LT((sum_of_tooth(back.state.force, tooth) - sum).norm(), 1e-13);
    for (unsigned int node = 0; node < 15; ++node)
    {
      const unsigned int i = 15 * tooth + node;
      EXPECT_EQ(finer.state.force[i][0] > 0., node < 5) << node;
      EXPECT_EQ(finer.motion[i][0] > 0., node >= 5) << node;
      if (node < 5)
      {
        EXPECT_EQ(finer.status[i], PointStatus::slip);
      }
    }
  }
}
