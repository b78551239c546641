// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The quantities of an operating point in torque_speed.csv, contact.h5 and summary.json, and those
// of its losses in losses.csv, efficiency.csv and summary.json, read back and compared with the
// numbers written; some with units converted by hand.

#include "parameters/sample.h"
#include "scratch.h"

#include <ringmotor/output/contact_files.h>
#include <ringmotor/output/contact_h5.h>
#include <ringmotor/output/contact_summary.h>
#include <ringmotor/output/hdf5.h>
#include <ringmotor/output/losses_files.h>
#include <ringmotor/points/error_cause.h>
#include <ringmotor/points/point_quantities.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <set>
#include <sstream>

using namespace ringmotor;
using namespace ringmotor::tests;
using ringmotor::sample::with;

namespace
{
  /** An operating point whose numbers all differ. */
  CurvePoint some_point()
  {
    CurvePoint point;
    point.request  = {Control::torque, 0.05};
    double counter = 1.;
    for (double OperatingPoint::*const member : OperatingPoint::members())
      point.result.*member = counter += 0.37;
    point.rotor_power    = 1.1e-3;
    point.rotor_energies = {1.};
    for (const auto &cause : all_error_causes())
      point.errors[cause->name] = {};
    point.errors[causes::meshes] = {
        {{"speed", 0.25}, {"friction_loss", 1e-3}, {"rotor_power_per_loss_factor", 2e-5}}};
    point.errors[causes::time_step] = {
        {{"speed", 0.5}, {"friction_loss", 2e-3}, {"rotor_power_per_loss_factor", 3e-5}}};
    point.errors[causes::wave]["amplitude"] = 1e-3; // of a driven wave
    point.fields.times                      = {0.};
    point.fields.n_repeating_teeth          = 1;
    point.fields.state.force = point.fields.motion = point.fields.tooth = point.fields.rotor = {{}};
    point.fields.status = {PointStatus::open};
    return point;
  }

  /** The only row of a table, by column name. */
  std::map<std::string, std::string> row_of(const std::string &csv)
  {
    std::istringstream lines(csv);
    std::string head, row, name, entry;
    std::getline(lines, head);
    std::getline(lines, row);
    std::map<std::string, std::string> entries;
    std::istringstream names(head), values(row);
    while (std::getline(names, name, ',') && std::getline(values, entry, ','))
      entries[name] = entry;
    return entries;
  }

  /** The outputs of an operating point. */
  class Outputs
  {
  public:
    explicit Outputs(const CurvePoint &point)
    {
      write_torque_speed(scratch.path("torque_speed.csv"), {point});
      csv = row_of(content_of(scratch.path("torque_speed.csv")));
      CondensedMotor motor;
      motor.nodes.resize(1);
      motor.wave.free_motion.resize(1);
      wave.fingerprint = "wave";
      write_contact_h5(path(), parameters, wave, motor, {point});
      Summary summary;
      add_points(summary, {point});
      write_summary(scratch.path("summary.json"), summary);
      const auto all = nlohmann::json::parse(content_of(scratch.path("summary.json")));
      for (const char *const list : {"quantities", "quantities_without_error"})
        for (const auto &quantity : all[list])
          json[quantity["name"]] = quantity;
    }

    std::string path() const { return scratch.path("contact.h5"); }
    double in_csv(const std::string &column) const { return std::stod(csv.at(column)); }
    double in_h5(const std::string &name) const
    {
      return Hdf5Reader(path(), "ringmotor contact", contact_format_version)
          .attribute<double>("points/000", name);
    }
    CurvePoint read() const { return read_contact_points(path(), parameters, wave).front(); }

    const Scratch scratch;
    const Parameters parameters = with({});
    StatorWave wave;
    std::map<std::string, std::string> csv;
    std::map<std::string, nlohmann::json> json; ///< entries of the summary by name
  };

  // Names that summary.json has always had.
  std::string name_in_summary(const PointQuantity &quantity)
  {
    return quantity.name == "tangential_loss" ? "friction_loss_tangential"
           : quantity.name == "radial_loss"   ? "friction_loss_radial"
                                              : quantity.name;
  }
} // namespace

TEST(PointQuantities, AreInAllOutputs)
{
  const CurvePoint point = some_point();
  const Outputs outputs(point);
  for (const PointQuantity &quantity : point_quantities())
  {
    SCOPED_TRACE(quantity.name);
    const double value       = quantity.value(point);
    const std::string column = name_with_unit(quantity.name, quantity.unit.shown);
    ASSERT_EQ(outputs.csv.count(column), 1u);
    EXPECT_DOUBLE_EQ(outputs.in_csv(column) * quantity.unit.size, value);
    EXPECT_EQ(outputs.csv.count(name_with_unit(quantity.name + "_error", quantity.unit.shown)),
              !quantity.error_of.empty());
    EXPECT_EQ(outputs.in_h5(name_with_unit(quantity.name, quantity.unit.si)), value);
    if (quantity.name == "torque") // prescribed
      continue;
    ASSERT_EQ(outputs.json.count(name_in_summary(quantity)), 1u);
    const nlohmann::json &entry = outputs.json.at(name_in_summary(quantity));
    EXPECT_EQ(entry["value"], value);
    EXPECT_EQ(entry["unit"], quantity.unit.si);
    EXPECT_EQ(entry["torque_Nm"], 0.05);
    EXPECT_EQ(entry.contains("error"), !quantity.error_of.empty());
  }
  EXPECT_EQ(outputs.json.count("torque"), 0u);
}

TEST(PointQuantities, HaveTheUnitsOfTheirNames)
{
  CurvePoint point             = some_point();
  point.result.speed           = 10.;
  point.result.torque          = 0.05;
  point.result.tangential_loss = 0.06;
  point.result.radial_loss     = 0.04;
  const Outputs outputs(point);
  EXPECT_EQ(outputs.csv.at("control"), "torque");
  EXPECT_NEAR(outputs.in_csv("speed_rpm"), 95.4929658551372, 1e-12);
  EXPECT_NEAR(outputs.in_csv("speed_error_rpm"), std::hypot(0.25, 0.5) * 30. / M_PI, 1e-13);
  EXPECT_NEAR(outputs.in_csv("torque_mNm"), 50., 1e-12);
  EXPECT_EQ(outputs.in_csv("torque_error_mNm"), 0.);
  EXPECT_NEAR(outputs.in_csv("friction_loss_mW"), 100., 1e-12);
  EXPECT_NEAR(outputs.in_csv("friction_loss_error_mW"), std::hypot(1., 2.), 1e-12);
  EXPECT_NEAR(outputs.in_csv("output_power_mW"), 500., 1e-12);
  EXPECT_NEAR(outputs.in_csv("rotor_power_per_loss_factor_error_mW"), std::hypot(0.02, 0.03),
              1e-12);
  EXPECT_EQ(outputs.in_csv("stick_fraction"), point.result.stick_fraction);
  EXPECT_EQ(outputs.in_h5("speed_rad_per_s"), 10.);
  EXPECT_EQ(outputs.in_h5("torque_Nm"), 0.05);
  EXPECT_EQ(outputs.in_h5("radial_loss_W"), 0.04);
  const nlohmann::json &loss = outputs.json.at("friction_loss");
  EXPECT_EQ(loss["unit"], "W");
  EXPECT_DOUBLE_EQ(loss["error"], std::hypot(1e-3, 2e-3));
  EXPECT_EQ(loss["error_causes"]["meshes of bodies and interface"], 1e-3);
  EXPECT_EQ(loss["error_causes"]["time step"], 2e-3);
  EXPECT_EQ(outputs.json.at("speed")["error_causes"]["time step"], 0.5);
}

TEST(PointQuantities, ComeBackFromTheFile)
{
  const CurvePoint point = some_point(), read = Outputs(point).read();
  for (const PointQuantity &quantity : point_quantities())
    EXPECT_EQ(quantity.value(read), quantity.value(point)) << quantity.name;
  for (const PointQuantity &quantity : point_quantities())
    EXPECT_EQ(quantity.estimate(read).errors, quantity.estimate(point).errors) << quantity.name;
}

TEST(PointQuantities, KnowEveryNumberOfAnOperatingPoint)
{
  // A number missing from the list would be neither averaged nor saved.
  EXPECT_EQ(OperatingPoint::members().size() * sizeof(double), sizeof(OperatingPoint));
  const OperatingPoint point = some_point().result;
  std::set<double> numbers;
  for (double OperatingPoint::*const member : OperatingPoint::members())
    numbers.insert(point.*member);
  EXPECT_EQ(numbers.size(), OperatingPoint::members().size()) << "one is listed twice";
  OperatingPoint other;
  const OperatingPoint average = mean({point, other}, {3., 1.});
  for (double OperatingPoint::*const member : OperatingPoint::members())
    EXPECT_DOUBLE_EQ(average.*member, 0.75 * point.*member);
}

TEST(LossQuantities, AreInTheirTableAndInTheSummary)
{
  PointLosses losses{some_point(), {}, {}};
  losses.point.result.speed = 10.;
  losses.budget             = {2e-6,
                               {0.5, 0.04, "mesh"},
                               {0.1, 0.02, "mesh"},
                               0.2,
                               {0.03, 1e-3, "mesh"},
                               {0.01, 1e-3, "mesh"},
                               0.04,
                               0.05};
  losses.budget.rotor_metal = Estimate(0.01);
  losses.budget.lining      = Estimate(0.03);
  const Scratch scratch;
  write_losses(scratch.path("losses.csv"), {losses});
  write_efficiency(scratch.path("efficiency.csv"), {losses});
  Summary summary;
  add_losses(summary, {losses}, 1.);
  unsigned int n_told = 0;
  for (const auto &[table, list] : {std::pair("losses.csv", losses.budget.losses()),
                                    std::pair("efficiency.csv", losses.budget.powers())})
  {
    const auto csv = row_of(content_of(scratch.path(table)));
    EXPECT_NEAR(std::stod(csv.at("speed_rpm")), 95.4929658551372, 1e-12);
    for (const Quantity &quantity : list)
    {
      SCOPED_TRACE(quantity.name);
      const double factor    = quantity.name == "efficiency" ? 1. : 1e3;
      const std::string unit = quantity.name == "efficiency" ? "" : "_mW";
      EXPECT_NEAR(std::stod(csv.at(quantity.name + unit)), factor * quantity.value(), 1e-12);
      EXPECT_NEAR(std::stod(csv.at(quantity.name + "_error" + unit)),
                  factor * quantity.estimate.error(), 1e-12);
      const Summary::Result &told = summary.results.at(n_told++);
      EXPECT_EQ(told.quantity.name, quantity.name);
      EXPECT_EQ(told.quantity.value(), quantity.value());
      EXPECT_EQ(told.quantity.unit.si, std::string(unit.empty() ? "1" : "W"));
      EXPECT_EQ(told.quantity.estimate.errors, quantity.estimate.errors);
      EXPECT_EQ(std::get<double>(told.labels.at("speed_rad_per_s")), 10.);
    }
  }
  EXPECT_EQ(summary.results.size(), n_told);
  EXPECT_GE(n_told, 10u);
}
