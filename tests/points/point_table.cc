// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Fields of operating points, which are kept only where something needs them; from which points
// others start.

#include "support/made_up_points.h"

#include <ringmotor/points/point_table.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

using namespace ringmotor;

namespace
{
  /** Points with fields of one value. */
  class PointsWithFields : public PointSource
  {
  public:
    std::vector<TimedMotor> motors(const std::vector<unsigned int> &levels,
                                   const unsigned int) override
    {
      return std::vector<TimedMotor>(levels.size());
    }

    std::vector<std::vector<CurvePoint>> points(const std::vector<PointSet> &sets) override
    {
      std::vector<std::vector<CurvePoint>> all;
      for (const PointSet &set : sets)
      {
        all.emplace_back();
        for (const PointRequest &request : set.requests)
        {
          CurvePoint point;
          point.request          = request;
          point.fields.time_step = 1e-7;
          point.fields.state.force.resize(n_values);
          all.back().push_back(point);
          n_anew += set.anew;
        }
      }
      return all;
    }

    void replace(const Discretisation &discretisation, const CurvePoint &point) override
    {
      replaced.emplace_back(discretisation.text(), point.fields.state.force.size());
    }

    std::vector<std::pair<std::string, std::size_t>> replaced; ///< with their fields
    unsigned int n_anew  = 0;
    std::size_t n_values = 1;
  };
} // namespace

TEST(PointTable, StartsFromTheFirstCurveOnTheMeshOfEachPoint)
{
  using tests::MadeUpPoints;
  /** Remembers the sizes of the fields from which points start. */
  class Starts : public MadeUpPoints
  {
  public:
    Starts() : MadeUpPoints(0.2, 0.1) {}
    std::vector<std::vector<CurvePoint>> points(const std::vector<PointSet> &sets) override
    {
      for (const PointSet &set : sets)
        for (const CurvePoint &start : set.starts)
          n_points.push_back(start.fields.state.force.size());
      return MadeUpPoints::points(sets);
    }
    std::vector<std::size_t> n_points;
  };
  const Parameters parameters;
  const StepChoice steps(parameters, tests::period);
  Starts source;
  PointTable table(parameters, steps, source);
  const Discretisation on_first_mesh{1, 0, steps.plain()}, on_other_mesh{0, 0, steps.longest()};
  const PointRequest known{Control::torque, 0.}, similar{Control::torque, 1.};
  table.begin_with(on_first_mesh, {table.at(on_first_mesh, known)});
  source.n_points.clear();
  table.fill({{on_other_mesh, {similar}}});
  EXPECT_EQ(source.n_points, std::vector<std::size_t>{4});
}

TEST(ContactFields, TellTheLargestShareOfForce)
{
  ContactFields fields;
  EXPECT_EQ(fields.largest_share(), 0.);
  for (const double pressure : {3., 1., 0., 4.})
  {
    fields.state.force.emplace_back();
    fields.state.force.back()[0] = pressure;
  }
  EXPECT_DOUBLE_EQ(fields.largest_share(), 0.5);
}

TEST(ContactFields, CountTheirMemory)
{
  ContactFields fields;
  fields.times     = {0., 1.};
  fields.time_step = 1.;
  fields.state.force.resize(4);
  fields.rotor.resize(4);
  EXPECT_EQ(fields.n_bytes(), (2 + 3 * (4 + 4)) * sizeof(double));
}

TEST(PointTable, DropsFieldsHereAndWhereTheyAreKept)
{
  Parameters parameters;
  parameters.time.scheme = TimeScheme::marching;
  PointsWithFields source;
  PointTable table(parameters, StepChoice(parameters, 1e-5), source);
  const PointRequest one{Control::torque, 0.}, two{Control::torque, 1.};
  const Discretisation coarse{0, 0, {1}}, fine{1, 0, {1}};
  table.fill({{coarse, {one, two}}, {fine, {one, two}}});
  const auto n_values = [&](const Discretisation &discretisation, const PointRequest &request)
  { return table.at(discretisation, request).fields.state.force.size(); };
  EXPECT_EQ(n_values(coarse, one), 1u);

  table.drop_other_fields({{fine, {two}}});
  EXPECT_EQ(n_values(coarse, one), 0u);
  EXPECT_EQ(n_values(fine, one), 0u);
  EXPECT_EQ(n_values(fine, two), 1u);
  EXPECT_EQ(table.at(fine, one).fields.time_step, 1e-7);
  EXPECT_EQ(source.replaced, (std::vector<std::pair<std::string, std::size_t>>{
                                 {coarse.text(), 0}, {coarse.text(), 0}, {fine.text(), 0}}));

  source.replaced.clear();
  table.restore_fields({{fine, {one, two}}});
  EXPECT_EQ(source.n_anew, 1u);
  EXPECT_EQ(n_values(fine, one), 1u);
  EXPECT_EQ(source.replaced, (std::vector<std::pair<std::string, std::size_t>>{{fine.text(), 1}}));
}

TEST(PointTable, DoesNotKeepLargeFieldsButHasThem)
{
  Parameters parameters;
  parameters.time.scheme = TimeScheme::marching;
  PointsWithFields source;
  source.n_values = 5'000'000;
  PointTable table(parameters, StepChoice(parameters, 1e-5), source);
  const Discretisation fine{1, 0, {1}};
  const PointTable::Needs own{{fine, {{Control::torque, 0.}}}};
  table.fill(own);
  table.drop_other_fields(own);
  EXPECT_EQ(source.replaced, (std::vector<std::pair<std::string, std::size_t>>{{fine.text(), 0}}));
  EXPECT_EQ(table.at(fine, own.front().second.front()).fields.state.force.size(), source.n_values);
}
