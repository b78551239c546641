// SPDX-License-Identifier: LGPL-2.1-or-later

// Derivatives of the results with respect to the entries. Expected: what dimensional analysis says
// of their sums, whatever the motor and its meshes: a motor in other units of mass, length or time
// is the same motor.

#include "../support/motor_model.h"
#include "../support/record.h"

#include <ringmotor/parameters/errors.h>
#include <ringmotor/sensitivity/sensitivities.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  /** Exponents of mass, length and time. */
  struct Dimension
  {
    int mass, length, time;
  };

  const std::map<std::string, Dimension> dimension_of_unit{
      {"none", {0, 0, 0}},    {"m", {0, 1, 0}},  {"m^2", {0, 2, 0}},     {"Pa", {1, -1, -2}},
      {"kg/m^3", {1, -3, 0}}, {"N", {1, 1, -2}}, {"N/m^2", {1, -1, -2}}, {"N/m^3", {1, -2, -2}},
      {"N/m", {1, 0, -2}},    {"Hz", {0, 0, -1}}};

  /** Of the sensitive_quantities(), by their units. */
  Dimension dimension_of(const SensitiveQuantity &quantity)
  {
    const std::string unit = quantity.unit.si;
    if (unit == "N m")
      return {1, 2, -2};
    if (unit == "W")
      return {1, 2, -3};
    return unit == "1" ? Dimension{0, 0, 0} : Dimension{0, 0, -1};
  }

  double derivative(const std::vector<Sensitivity> &all, const std::string &path,
                    const std::string &quantity)
  {
    const auto &quantities = sensitive_quantities();
    for (const Sensitivity &one : all)
      for (std::size_t i = 0; i < quantities.size(); ++i)
        if (one.entry.path == path && quantities[i].name == quantity)
          return one.of.at(i).value;
    return 0.;
  }
} // namespace

TEST(Sensitivities, OfPowersAreTheirExponents)
{
  constexpr double exponent = -1.5, step = 0.01, curvature = 2.;
  const auto logarithm = [](const double x) { return exponent * x + 0.5 * curvature * x * x; };
  for (const auto &[side, first] :
       {std::make_pair(Side::below, -2), {Side::both, -1}, {Side::above, 0}})
  {
    const LogDerivative found = log_derivative(
        {logarithm(first * step), logarithm((first + 1) * step), logarithm((first + 2) * step)},
        side, step);
    EXPECT_NEAR(found.value, exponent, 1e-12);
    EXPECT_NEAR(found.error, 0.5 * curvature * step, 1e-12); // half of the slopes' difference
  }
}

TEST(Sensitivities, KnowTheEntriesOfTheMotor)
{
  const Parameters parameters = reference_motor();
  std::map<std::string, MotorEntry> entries;
  for (const MotorEntry &entry : motor_entries(parameters))
    entries.emplace(entry.path, entry);
  EXPECT_EQ(entries.at("Loading/Preload").value, parameters.loading.preload);
  EXPECT_EQ(entries.at("Materials/Stator metal/Young modulus").units, "Pa");
  for (const char *const other : {"Accuracy/Target", "Time/Time step", "Motor/Number of teeth",
                                  "Rotor/Flange lower face", "Loading/Values"})
    EXPECT_EQ(entries.count(other), 0u) << other; // of the run, whole, 0, a list
  // What is between the lip's radii is small against them.
  EXPECT_NEAR(entries.at("Rotor/Lip inner radius").scale,
              parameters.rotor.lip_outer_radius - parameters.rotor.lip_inner_radius, 1e-12);
  const double thinner     = 1. / 3. * parameters.rotor.flange_thickness;
  const MotorEntry &flange = entries.at("Rotor/Flange thickness");
  EXPECT_EQ(with_entry(parameters, flange, thinner).rotor.flange_thickness, thinner);
  EXPECT_THROW(with_entry(parameters, flange, -thinner), UserError);
  // Both bodies end at the contact line, and stay there.
  ASSERT_EQ(entries.count("Rotor/Lip outer radius"), 0u);
  const Parameters larger = with_entry(parameters, entries.at("Stator/Tip outer radius"), 0.035);
  EXPECT_EQ(larger.stator.tip_outer_radius, 0.035);
  EXPECT_EQ(larger.rotor.lip_outer_radius, 0.035);
}

TEST(SensitivitiesLong, AddUpAsInOtherUnits)
{
  const NearbyStators stators(reference_motor());
  const NearbyMotors motors(stators, {0, 1, Steps{1, 1}});
  const auto all         = sensitivities(motors, 0.002, MPI_COMM_SELF);
  const auto &quantities = sensitive_quantities();
  std::map<bool, double> largest_miss; // of the frequency or not
  for (const auto base : {&Dimension::mass, &Dimension::time, &Dimension::length})
  {
    for (std::size_t i = 0; i < quantities.size(); ++i)
    {
      double sum = 0., error = 0.;
      for (const Sensitivity &one : all)
      {
        ASSERT_EQ(one.obstacle, "") << one.entry.path;
        const int exponent = dimension_of_unit.at(one.entry.units).*base;
        sum += exponent * one.of.at(i).value;
        error += std::abs(exponent) * one.of.at(i).error;
      }
      const double miss = std::abs(sum - dimension_of(quantities[i]).*base);
      EXPECT_LE(miss, 2e-3 + error) << quantities[i].name << ", " << sum;
      double &largest = largest_miss[quantities[i].name == "frequency"];
      largest         = std::max(largest, miss);
    }
    record("largest miss of a sum so far (mass, time, length)", largest_miss[false]);
  }
  EXPECT_LE(largest_miss[true], 2e-3);
  // Each modulus is a part of the square of the frequency.
  EXPECT_NEAR(derivative(all, "Materials/Stator metal/Young modulus", "frequency") +
                  derivative(all, "Materials/Piezoceramic/Young modulus", "frequency"),
              0.5, 1e-4);
  EXPECT_NEAR(derivative(all, "Materials/Stator metal/Density", "frequency") +
                  derivative(all, "Materials/Piezoceramic/Density", "frequency"),
              -0.5, 1e-4);
  record("largest miss of a sum, frequency", largest_miss[true]);
}
