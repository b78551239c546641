// SPDX-License-Identifier: LGPL-2.1-or-later

// The list of effects: what each needs, what it adds to the model, how `auto` chooses, and that
// disabled effects cost nothing. Tests of single effects are next to the tests of their physics.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/motor/effect.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/parameters/declared_entries.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/effect_on_points.h>
#include <ringmotor/points/point_finder.h>
#include <ringmotor/points/point_quantities.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double rpm = M_PI / 30.;

  Parameters with(const std::string &name, const EffectChoice choice)
  {
    Parameters parameters    = reference_motor();
    parameters.effects[name] = choice;
    return parameters;
  }

  void expect_refused(const Parameters &parameters, const EffectStage stage,
                      const std::vector<std::string> &words)
  {
    try
    {
      check_effects(parameters, stage);
      FAIL() << words.front() << " is not refused";
    }
    catch (const UserError &error)
    {
      for (const std::string &word : words)
        EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }
} // namespace

TEST(Effects, HaveEachAnEntryOfTheirOwn)
{
  std::set<std::string> names;
  for (const auto &one : all_effects())
  {
    EXPECT_TRUE(names.insert(one->name).second) << one->name;
    const Parameters off = with(one->name, EffectChoice::off);
    for (const auto &other : all_effects())
      EXPECT_EQ(other->choice(off) == EffectChoice::off,
                other->choice(reference_motor()) == EffectChoice::off || other == one)
          << one->name << " " << other->name;
  }
  dealii::ParameterHandler prm;
  Effects().declare(prm);
  const DeclaredEntries declared(prm);
  for (const std::string &name : names)
    EXPECT_NE(declared.find(name), nullptr) << name;
  EXPECT_EQ(names.size(), 15u);
}

TEST(Effects, SayWhatTheyNeed)
{
  Parameters lining = with("Friction lining", EffectChoice::on);
  expect_refused(lining, EffectStage::contact,
                 {"Effects/Friction lining = on", "Lining normal stiffness", "N/m^3"});
  Parameters warped                    = with("Rotor inertia", EffectChoice::on);
  warped.initial_deformation.amplitude = 4e-6;
  warped.rotor.radial_bar_stiffness    = 0.;
  expect_refused(warped, EffectStage::contact,
                 {"Effects/Rotor inertia = on", "Rotor/Radial bar stiffness = 0", "allowed: off"});
  warped.effects["Rotor inertia"] = EffectChoice::automatic; // may not be needed
  EXPECT_NO_THROW(check_effects(warped, EffectStage::contact));
  Parameters few    = with("Rotor inertia", EffectChoice::on);
  few.motor.n_waves = 3;
  few.motor.n_teeth = 16;
  expect_refused(few, EffectStage::contact, {"harmonic 5", "allowed: off"});
  Parameters in_time  = with("Damping", EffectChoice::on);
  in_time.time.scheme = TimeScheme::marching;
  expect_refused(in_time, EffectStage::contact,
                 {"Effects/Damping = on", "Rotor inertia = off", "allowed: off"});
  expect_refused(with("Spin convection", EffectChoice::on), EffectStage::contact,
                 {"Effects/Spin convection = on", "not available", "allowed: off"});
  Parameters marched  = with("Stator back-reaction", EffectChoice::on);
  marched.time.scheme = TimeScheme::marching;
  expect_refused(marched, EffectStage::contact, {"Effects/Stator back-reaction = on", "marching"});
  Parameters plates               = with("Target plates", EffectChoice::on);
  plates.stator.target_plate_area = 1e-5;
  expect_refused(plates, EffectStage::stator,
                 {"Stator/Target plate cross-section = 1e-05 m^2", "4e-07 m^2"});
  plates.stator.mesh_file = "any.msh";
  expect_refused(plates, EffectStage::stator, {"Effects/Target plates = on", "any.msh"});
  Parameters felt                = with("Felt support", EffectChoice::on);
  felt.support.felt_outer_radius = 0.034;
  expect_refused(felt, EffectStage::stator, {"Effects/Felt support = on", "Felt outer radius"});
}

TEST(Effects, DampAStaticRotorOnlyIfThatWasChosen)
{
  EXPECT_FALSE(motor_model(with("Damping", EffectChoice::automatic)).rotor_needs_modes());
  EXPECT_TRUE(motor_model(with("Damping", EffectChoice::on)).rotor_needs_modes());
  Parameters vibrating               = with("Damping", EffectChoice::automatic);
  vibrating.effects["Rotor inertia"] = EffectChoice::on;
  EXPECT_GT(motor_model(vibrating).rotor_loss_factor, 0.);
}

TEST(Effects, AreChosenByAShareOfTheTargetThatGrowsWithTheirPrice)
{
  const StatorWave wave = stator_wave(reference_motor());
  const auto choice_of  = [&](const std::string &name, const double indicator)
  {
    Parameters parameters                  = with(name, EffectChoice::automatic);
    parameters.effects["Tooth inertia"]    = EffectChoice::on;
    parameters.friction.law                = FrictionLaw("static-dynamic");
    parameters.friction.static_coefficient = 1.2 * parameters.friction.dynamic_coefficient;
    const Scene scene{parameters, &wave, [&](const Effect &) { return indicator; }};
    for (const EffectRow &row : choose_effects(parameters, EffectStage::contact, scene, 0.03))
      if (row.name == name)
      {
        EXPECT_EQ(row.choice == "on", parameters.effects[name] == EffectChoice::on);
        EXPECT_EQ(row.indicator, indicator) << name;
      }
    return parameters.effects[name];
  };
  EXPECT_EQ(choice_of("Tooth vibration", 0.011), EffectChoice::on);
  EXPECT_EQ(choice_of("Tooth vibration", 0.009), EffectChoice::off);
  EXPECT_EQ(choice_of("Tooth vibration", -0.011), EffectChoice::on);
  // Twice the time of a point, and five times: half and five sevenths of the target.
  EXPECT_EQ(choice_of("Static friction excess", 0.0151), EffectChoice::on);
  EXPECT_EQ(choice_of("Static friction excess", 0.0149), EffectChoice::off);
  EXPECT_EQ(choice_of("Rotor inertia", 0.0216), EffectChoice::on);
  EXPECT_EQ(choice_of("Rotor inertia", 0.0212), EffectChoice::off);
}

TEST(Effects, ThatAreNeededButNotAvailableStopTheProgram)
{
  // Up to the target they are in the error bars.
  // Seven waves of 2 um, of which the tops move 1.5 um along a radius of 34.2 mm.
  const double indicator = 7. * 1.5e-6 / 34.2e-3;
  const StatorWave wave  = stator_wave(reference_motor());
  Parameters parameters  = with("Spin convection", EffectChoice::automatic);
  const Scene scene{parameters, &wave, {}};
  const std::vector<EffectRow> rows =
      choose_effects(parameters, EffectStage::contact, scene, 2. * indicator);
  EXPECT_EQ(parameters.effects["Spin convection"], EffectChoice::off);
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [](const EffectRow &r) { return r.name == "Spin convection"; });
  EXPECT_NEAR(*row->indicator, indicator, 0.2 * indicator);
  EXPECT_TRUE(row->is_left_out());
  parameters = with("Spin convection", EffectChoice::automatic);
  try
  {
    choose_effects(parameters, EffectStage::contact, scene, 0.7 * indicator);
    FAIL() << "is not refused";
  }
  catch (const ComputationError &error)
  {
    for (const std::string words :
         {"Effects/Spin convection = auto: it would change the results by", "is not available",
          "allowed: off, or a larger target"})
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Effects, ThatAreLeftOutWidenTheErrorBars)
{
  EffectOnPoints inertia;
  inertia.changes      = {{0., PointError({{"speed", 0.2}, {"friction_loss", 0.01}})},
                          {0.4, PointError({{"speed", 0.3},
                                            {"torque", 0.004},
                                            {"friction_loss", 0.03},
                                            {"rotor_power_per_loss_factor", 2.}})},
                          {1., PointError({{"speed", 0.7}, {"torque", 0.008}})}};
  inertia.stall_torque = 0.2;
  inertia.relative     = 0.03;
  const LeftOut left_out({{"Tooth inertia", 0.02, "off", true},
                          {"Rotor inertia", 0.03, "off", true},
                          {"Stator back-reaction", 0.5, "off", false}, // as set by the user
                          {"Tooth vibration", 0.2, "on", true}},
                         {{"Rotor inertia", inertia}});
  CurvePoint point;
  point.request                = {Control::torque, 0.05};
  point.result.speed           = 8.;
  point.result.torque          = 0.05;
  point.result.tangential_loss = 0.1;
  const PointError error       = left_out.of(point);
  EXPECT_NEAR(error["speed"], std::hypot(0.02 * 8., 0.3), 1e-12);
  EXPECT_EQ(error["torque"], 0.);
  EXPECT_NEAR(error["friction_loss"], std::hypot(0.02 * 0.1, 0.03), 1e-12);
  EXPECT_NEAR(error["rotor_power_per_loss_factor"], 2., 1e-12);
  // The larger change of both sides counts, at a load its own and the next one, beyond all the
  // last.
  for (const auto &[torque, change] :
       {std::pair(-0.1, 0.3), std::pair(0., 0.3), std::pair(0.025, 0.3), std::pair(0.15, 0.7),
        std::pair(0.2, 0.7), std::pair(0.3, 0.7)})
  {
    point.request.value = point.result.torque = torque;
    EXPECT_NEAR(left_out.of(point)["speed"], std::hypot(0.02 * 8., change), 1e-12) << torque;
  }
  // At a given speed it is the torque that changes.
  point.request       = {Control::speed, 8.};
  point.result.torque = 0.15;
  EXPECT_EQ(left_out.of(point)["speed"], 0.);
  EXPECT_NEAR(left_out.of(point)["torque"], std::hypot(0.02 * 0.15, 0.008), 1e-12);
}

TEST(Effects, ThatAreOffCostNothing)
{
  Parameters parameters = reference_motor();
  for (const auto &one : all_effects())
    parameters.effects[one->name] = EffectChoice::off;
  parameters.effects["Tooth shear"] = EffectChoice::on;
  const StatorWave wave             = stator_wave(parameters);
  const CondensedMotor without = condense_motor(parameters, wave, ContactDiscretisation::level(0));
  EXPECT_TRUE(without.modes.empty());
  EXPECT_TRUE(without.coarse_modes.empty());
  std::vector<EffectRow> rows{{"Rotor inertia", {}, "off"}, {"Tooth vibration", {}, "off"}};
  add_costs(without, rows);
  for (const EffectRow &row : rows)
    EXPECT_EQ(row.dofs + row.bytes, 0u) << row.name;
  parameters.effects["Tooth inertia"]   = EffectChoice::on;
  parameters.effects["Tooth vibration"] = EffectChoice::on;
  const CondensedMotor with_teeth =
      condense_motor(parameters, wave, ContactDiscretisation::level(0));
  add_costs(with_teeth, rows);
  EXPECT_EQ(rows[0].dofs + rows[0].bytes, 0u);
  EXPECT_GT(rows[1].dofs, 0u);
}

TEST(ToothInertia, ChangesSpeedsAsItsIndicatorSays)
{
  Parameters parameters  = reference_motor();
  const StatorWave wave  = stator_wave(parameters);
  const double indicator = *effect("Tooth inertia").indicator({parameters, &wave, {}});
  const EffectOnPoints change =
      EffectsOnPoints(wave, MotorVibration(parameters, wave), MPI_COMM_SELF)
          .of(effect("Tooth inertia"), parameters);
  record("indicator", indicator);
  record("relative change of the operating points", change.relative);
  EXPECT_GT(change.relative, indicator / 3.);
  EXPECT_LT(change.relative, indicator * 3.);
}

TEST(ToothVibration, ChangesLessThanItsEstimate)
{
  // Without operating points an upper limit is estimated.
  Parameters parameters               = reference_motor();
  parameters.effects["Tooth inertia"] = EffectChoice::on;
  const StatorWave wave               = stator_wave(parameters);
  const Effect &vibration             = effect("Tooth vibration");
  const double indicator              = *vibration.indicator({parameters, &wave, {}});
  const EffectOnPoints change =
      EffectsOnPoints(wave, MotorVibration(parameters, wave), MPI_COMM_SELF)
          .of(vibration, parameters);
  record("indicator", indicator);
  record("relative change of the operating points", change.relative);
  EXPECT_GT(change.relative, indicator / 30.);
  EXPECT_LT(change.relative, indicator);
  // Far below the threshold it is not measured; without inertia of the teeth there is none.
  const Scene scene{parameters, &wave, [](const Effect &) { return 1.; }, {}, 10. * indicator};
  EXPECT_EQ(*vibration.indicator(scene), indicator);
  parameters.effects["Tooth inertia"] = EffectChoice::off;
  EXPECT_EQ(*vibration.indicator(scene), 0.);
  parameters.effects["Tooth vibration"] = EffectChoice::on;
  try
  {
    check_effects(parameters, EffectStage::contact);
    FAIL() << "accepted";
  }
  catch (const UserError &error)
  {
    EXPECT_NE(std::string(error.what())
                  .find("Effects/Tooth vibration = on is not available with Effects/Tooth inertia"),
              std::string::npos)
        << error.what();
  }
}

TEST(StatorCompliance, IsMeasuredAtOperatingPointsAndCostly)
{
  Parameters parameters = reference_motor();
  const StatorWave wave = stator_wave(parameters);
  const Effect &stator  = effect("Stator compliance");
  const MotorVibration vibration(parameters, wave);
  const EffectOnPoints change =
      EffectsOnPoints(wave, vibration, MPI_COMM_SELF).of(stator, parameters);
  record("relative change of the operating points", change.relative);
  EXPECT_GT(change.relative, 0.005);
  EXPECT_LT(change.relative, 0.05);
  // Where it would multiply the time of all points, `auto` leaves more of it to the error bars.
  const auto choice = [&](const double target)
  {
    Parameters chosen                   = parameters;
    chosen.effects["Stator compliance"] = EffectChoice::automatic;
    const Scene scene{chosen, &wave, [&](const Effect &) { return change.relative; }};
    choose_effects(chosen, EffectStage::contact, scene, target);
    return chosen.effects["Stator compliance"];
  };
  EXPECT_EQ(choice(1.9 * change.relative), EffectChoice::on);
  EXPECT_EQ(choice(2.1 * change.relative), EffectChoice::off);
  parameters.time.scheme                  = TimeScheme::marching;
  parameters.effects["Stator compliance"] = EffectChoice::on;
  expect_refused(parameters, EffectStage::contact,
                 {"Effects/Stator compliance = on", "Time/Scheme = marching"});
}

TEST(Effects, AreIncludedWhereTogetherTheyTakeMuchOfTheTarget)
{
  // Each is below its share of the target, all of them are not.
  Parameters parameters                        = reference_motor();
  parameters.materials.rotor_metal.loss_factor = 0.03;
  for (const std::string name : {"Rotor inertia", "Stator compliance", "Damping"})
    parameters.effects[name] = EffectChoice::automatic;
  const std::map<std::string, double> size{{"Rotor inertia", 0.075}, {"Stator compliance", 0.055}};
  const StatorWave wave = stator_wave(parameters);
  const auto chosen     = [&](const double target)
  {
    Parameters chosen = parameters;
    const Scene scene{chosen, &wave, [&](const Effect &effect) { return size.at(effect.name); }};
    choose_effects(chosen, EffectStage::contact, scene, target);
    return chosen.effects;
  };
  const auto tightly = chosen(0.115), loosely = chosen(0.2);
  EXPECT_EQ(tightly["Rotor inertia"], EffectChoice::on);
  EXPECT_EQ(tightly["Stator compliance"], EffectChoice::off);
  EXPECT_EQ(loosely["Rotor inertia"], EffectChoice::off);
}

TEST(EffectRanks, ChangesPointsAlikeOnTwo)
{
  Parameters parameters         = reference_motor();
  parameters.effects["Damping"] = EffectChoice::on;
  const StatorWave wave         = stator_wave(parameters);
  const auto change_on          = [&](MPI_Comm communicator)
  {
    const MotorVibration vibration(parameters, wave, communicator);
    return EffectsOnPoints(wave, vibration, communicator).of(effect("Rotor inertia"), parameters);
  };
  const EffectOnPoints one = change_on(MPI_COMM_SELF), two = change_on(MPI_COMM_WORLD);
  EXPECT_GT(one.relative, 0.01);
  EXPECT_NEAR(two.relative, one.relative, 1e-7);
  for (const PointQuantity &quantity : point_quantities())
    EXPECT_NEAR(two.largest()[quantity.name], one.largest()[quantity.name],
                1e-6 * one.largest()[quantity.name])
        << quantity.name;
}

TEST(Effects, MarchAWarpedRingOnlyWhereTheSchemeIsOpen)
{
  // What effects change is measured on a uniform ring: in the steady state, whatever the warp.
  Parameters warped                    = reference_motor();
  warped.initial_deformation.amplitude = 4e-6;
  warped.time.scheme                   = TimeScheme::automatic;
  EXPECT_TRUE(is_marched(warped));
  warped.time.scheme = TimeScheme::steady;
  EXPECT_FALSE(is_marched(warped));
}

TEST(Effects, LeaveSomeTangentialComplianceForCertain)
{
  Parameters rigid                             = with("Tooth shear", EffectChoice::off);
  rigid.effects["Rotor tangential compliance"] = EffectChoice::off;
  rigid.contact.formulation                    = ContactFormulation::mortar;
  rigid.friction.lining_normal_stiffness       = 1e13;
  rigid.friction.lining_tangential_stiffness   = 1e13;
  rigid.effects["Friction lining"]             = EffectChoice::automatic; // may leave it out
  expect_refused(rigid, EffectStage::contact, {"leave no tangential compliance"});
  rigid.effects["Friction lining"] = EffectChoice::on;
  EXPECT_NO_THROW(check_effects(rigid, EffectStage::contact));
}
