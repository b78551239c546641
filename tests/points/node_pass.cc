// SPDX-License-Identifier: LGPL-2.1-or-later
// The second stick of contact nodes in a pass. Expected: counted by hand.

#include <ringmotor/points/node_pass.h>

#include <gtest/gtest.h>

#include <string>

using namespace ringmotor;

namespace
{
  /** A step in which each node is open (o), braked (b), driven (d) or sticks (s), pressed by 1 N.
   */
  ContactSolution step_of(const std::string &nodes)
  {
    ContactSolution step;
    for (const char node : nodes)
    {
      step.status.push_back(node == 'o'   ? PointStatus::open
                            : node == 's' ? PointStatus::stick
                                          : PointStatus::slip);
      PointVector force;
      force[0] = node == 'o' ? 0. : 1.;
      force[1] = node == 'd' ? 0.4 : node == 'b' ? -0.4 : 0.1;
      step.state.force.push_back(node == 'o' ? PointVector() : force);
    }
    return step;
  }
} // namespace

TEST(NodePass, IsASecondStickAfterDriving)
{
  NodePass pass(3);
  // The first node goes through all phases of the paper, the second one is never driven, the third
  // one breaks contact after it was driven.
  const std::vector<std::pair<std::string, double>> steps{
      {"boo", 0.},      {"sbd", 0.}, {"dso", 0.}, {"dbs", 0.}, {"sss", 1. / 3.},
      {"sob", 1. / 2.}, {"bos", 0.}, {"oos", 0.}, {"soo", 0.}};
  for (const auto &[nodes, expected] : steps)
  {
    const ContactSolution step = step_of(nodes);
    EXPECT_DOUBLE_EQ(pass.second_stick_fraction(step), expected) << nodes;
    pass.add(step);
  }
}

TEST(NodePass, CountsByPressure)
{
  NodePass pass(2);
  pass.add(step_of("db"));
  ContactSolution step   = step_of("ss");
  step.state.force[0][0] = 3.;
  EXPECT_DOUBLE_EQ(pass.second_stick_fraction(step), 3. / 4.);
  EXPECT_EQ(NodePass(2).second_stick_fraction(step_of("oo")), 0.);
}
