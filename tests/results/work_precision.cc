// SPDX-License-Identifier: LGPL-2.1-or-later

// Work against precision of settings made up by hand: three points of one quantity, whose largest
// deviation from the best row over a scale of 2 is the distance; cheapest settings, front and price
// can be read off.

#include <ringmotor/results/work_precision.h>

#include <gtest/gtest.h>

using namespace ringmotor;

namespace
{
  StudyRow row(const std::string &value, const double seconds, const std::vector<double> &results)
  {
    StudyRow row;
    row.knob    = "knob";
    row.value   = value;
    row.seconds = seconds;
    if (!results.empty())
      row.results = {results, {}};
    return row;
  }

  /** Distances 0.1, 0.008, 0.02, 0.0005, none and, of the best, 0. */
  WorkPrecision made_up()
  {
    return {{row("coarse", 1., {1., 2.2, 3.}), row("fine", 4., {1., 2., 3.016}),
             row("dear", 5., {1.04, 2., 3.}), row("finer", 20., {1.001, 2., 3.}),
             row("unsolved", 0.5, {}), row("best", 100., {1., 2., 3.})},
            {{"speed", 2.}, {"torque", 1.}},
            5};
  }
} // namespace

TEST(WorkPrecision, MeasuresTheLargestDistanceFromTheBest)
{
  const WorkPrecision study = made_up();
  ASSERT_EQ(study.quantities().size(), 1u) << "a quantity without values is left out";
  EXPECT_EQ(study.quantities().front().name, "speed");
  EXPECT_NEAR(*study.distance(0, 0), 0.1, 1e-12);
  EXPECT_NEAR(*study.distance(1, 0), 0.008, 1e-12);
  EXPECT_FALSE(study.distance(4, 0));
  EXPECT_EQ(*study.distance(5, 0), 0.);
}

TEST(WorkPrecision, FindsTheCheapestSetting)
{
  const WorkPrecision study = made_up();
  EXPECT_EQ(study.cheapest(0, 0.2), 0u);
  EXPECT_EQ(study.cheapest(0, 0.02 * (1. + 1e-9)), 1u) << "that of 0.02 is dearer";
  EXPECT_EQ(study.cheapest(0, 1e-3), 3u);
  EXPECT_FALSE(study.cheapest(0, 1e-4)) << "the best setting says nothing of its own error";
}

TEST(WorkPrecision, HasOnTheFrontWhatNothingBeats)
{
  EXPECT_EQ(made_up().front(0), (std::vector<unsigned int>{0, 1, 3}));
}

TEST(WorkPrecision, TellsThePriceOfTheNextDigit)
{
  const WorkPrecision study = made_up();
  EXPECT_DOUBLE_EQ(*study.price(0, 1e-2, 1e-3), 5.);
  EXPECT_FALSE(study.price(0, 1e-3, 1e-4));
}
