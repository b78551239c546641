// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice of operating points on a torque-speed curve, for polygons.

#include <ringmotor/points/curve_requests.h>

#include <gtest/gtest.h>

using namespace ringmotor;

namespace
{
  std::vector<CurvePoint> polygon(const std::vector<std::pair<double, double>> &corners)
  {
    std::vector<CurvePoint> points;
    for (const auto &[torque, speed] : corners)
    {
      points.emplace_back();
      points.back().result.torque = torque;
      points.back().result.speed  = speed;
    }
    return points;
  }

  void expect_requests(const std::vector<PointRequest> &found,
                       const std::vector<PointRequest> &expected)
  {
    ASSERT_EQ(found.size(), expected.size());
    for (unsigned int i = 0; i < found.size(); ++i)
    {
      EXPECT_EQ(found[i].control, expected[i].control) << i;
      EXPECT_NEAR(found[i].value, expected[i].value, 1e-12) << i;
    }
  }

  constexpr Control by_torque = Control::torque, by_speed = Control::speed;
} // namespace

TEST(CurvePoints, AreMeasuredAtTheEndsOfEachPartAndEvenlyBetween)
{
  std::vector<PointRequest> curve;
  for (unsigned int i = 0; i < 8; ++i)
    curve.push_back({by_torque, 0.1 * i});
  for (unsigned int i = 0; i < 3; ++i)
    curve.push_back({by_speed, 2. - i});
  const MeasuredPoints some(curve, 4);
  expect_requests(some.all(), {curve[0], curve[3], curve[7], curve[8], curve[10]});
  expect_requests(some.around(curve[0]), {curve[0]});
  expect_requests(some.around(curve[2]), {curve[0], curve[3]});
  expect_requests(some.around(curve[3]), {curve[3]});
  expect_requests(some.around(curve[5]), {curve[3], curve[7]});
  expect_requests(some.around(curve[9]), {curve[8], curve[10]});
  MeasuredPoints more = some;
  more.add(curve[5]);
  expect_requests(more.all(), {curve[0], curve[3], curve[5], curve[7], curve[8], curve[10]});
  expect_requests(more.around(curve[5]), {curve[5]});
  expect_requests(more.around(curve[4]), {curve[3], curve[5]});
  expect_requests(more.around(curve[6]), {curve[5], curve[7]});
  expect_requests(MeasuredPoints(curve, 1).all(), curve);
  const std::vector<PointRequest> short_curve{curve[0], curve[4], curve[10]};
  expect_requests(MeasuredPoints(short_curve, 4).all(), short_curve);
}

TEST(CurvePoints, OfAStraightCurveAreAtEqualTorques)
{
  expect_requests(
      points_along_curve(polygon({{0., 8.}, {0.05, 6.}, {0.2, 0.}}), 5),
      {{by_torque, 0.}, {by_torque, 0.05}, {by_torque, 0.1}, {by_torque, 0.15}, {by_speed, 0.}});
}

TEST(CurvePoints, AreAskedForBySpeedWhereTheCurveIsSteep)
{
  // Flat to the stall torque of 0.2 N m, then straight down from 8 rad/s.
  expect_requests(points_along_curve(polygon({{0., 8.}, {0.1, 8.}, {0.2, 8.}, {0.2, 0.}}), 8),
                  {{by_torque, 0.},
                   {by_torque, 0.04},
                   {by_torque, 0.08},
                   {by_torque, 0.12},
                   {by_torque, 0.16},
                   {by_torque, 0.2},
                   {by_speed, 4.},
                   {by_speed, 0.}});
  expect_requests(points_along_curve(polygon({{0., 8.}, {0.2, 0.}}), 2),
                  {{by_torque, 0.}, {by_speed, 0.}});
}
