// SPDX-License-Identifier: LGPL-2.1-or-later

// Means over spans of a marched motor: the estimated remaining change of a sequence of means
// against geometric sequences with known limits; the error of means that wander against Student's
// distribution and against sequences with known means.

#include "support/record.h"

#include <ringmotor/points/span_means.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace ringmotor;
using namespace ringmotor::tests;

TEST(RemainingChange, HoldsTheLimitOfAGeometricSequence)
{
  for (const double ratio : {0.01, 0.3, 0.7, 0.89, -0.5, -0.8})
  {
    std::vector<double> means;
    for (unsigned int k = 0; k < 12; ++k)
    {
      means.push_back(5. + std::pow(ratio, k));
      if (k < 2)
      {
        EXPECT_TRUE(std::isinf(remaining_change(means)));
        continue;
      }
      const double error = std::abs(means.back() - 5.), estimate = remaining_change(means);
      EXPECT_GE(estimate, error * (1. - 1e-6)) << ratio;
      EXPECT_LE(estimate, 20. * std::abs(std::pow(ratio, k - 2))) << ratio; // not too long
    }
  }
  // A sequence whose changes do not decrease does not settle, however small the last change.
  EXPECT_GE(remaining_change({4., 6., 4., 6.}), 2.);
  EXPECT_GE(remaining_change({1., 2., 3., 4.}), 5.);
  EXPECT_GE(remaining_change({1., 3., 3.}), 2.);
}

TEST(LaterMean, IsThatOfThreeQuartersWithTheErrorByStudent)
{
  EXPECT_TRUE(std::isinf(later_mean(std::vector<double>(11, 1.)).error));
  // By hand: quarters 1, 2 and 6 after what happened at first; variance 7.
  const std::vector<double> values{90., -9., 3., 0., 2., 1., 1., 3., 2., 6., 6., 6.};
  const LaterMean by_hand = later_mean(values);
  EXPECT_DOUBLE_EQ(by_hand.mean, 3.);
  EXPECT_NEAR(by_hand.error, 4.302653 * std::sqrt(7. / 3.), 1e-3);
  std::vector<double> thirteen = values;
  thirteen.insert(thirteen.begin(), 70.); // the later nine again
  EXPECT_DOUBLE_EQ(later_mean(thirteen).mean, 3.);
}

TEST(LaterMean, HoldsTheMeanOfMostWanderings)
{
  // Each value remembers the one before by a factor; the mean is 5. Bars of successive values of a
  // slow wandering are too short at first, as no finite sequence tells.
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0., 1.);
  for (const double memory : {0., 0.5, 0.8})
    for (const unsigned int n : {12u, 16u, 40u})
    {
      unsigned int n_held             = 0;
      constexpr unsigned int n_trials = 2000;
      for (unsigned int trial = 0; trial < n_trials; ++trial)
      {
        std::vector<double> values;
        double deviation = normal(random) / std::sqrt(1. - memory * memory);
        for (unsigned int i = 0; i < n; ++i)
        {
          values.push_back(5. + deviation);
          deviation = memory * deviation + normal(random);
        }
        const LaterMean later = later_mean(values);
        n_held += std::abs(later.mean - 5.) <= later.error ? 1 : 0;
      }
      const double held = static_cast<double>(n_held) / n_trials;
      record("share held, memory 0, 0.5, 0.8, of 12, 16, 40 values", held);
      if (memory == 0.)
      {
        EXPECT_NEAR(held, 0.95, 0.02); // what Student's distribution says
      }
      EXPECT_GE(held, memory == 0.8 && n < 40 ? 0.6 : 0.8);
    }
}

TEST(LaterMean, HoldsThatOfAnOscillation)
{
  // Of any period and phase, but for errors that are small beside its amplitude: quarters that
  // happen to last whole periods have the same mean.
  constexpr double small = 0.125;
  for (const double period : {1.7, 3., 5., 8., 13.})
    for (unsigned int n = 12; n <= 40; n += 4)
    {
      unsigned int n_held = 0;
      for (unsigned int phase = 0; phase < 100; ++phase)
      {
        std::vector<double> values;
        for (unsigned int i = 0; i < n; ++i)
          values.push_back(5. + std::sin(2. * M_PI * (i / period + phase / 100.)));
        const LaterMean later = later_mean(values);
        n_held += std::abs(later.mean - 5.) <= std::max(small, later.error) ? 1 : 0;
      }
      EXPECT_GE(n_held, 80u) << period << " " << n;
    }
}
