// SPDX-License-Identifier: LGPL-2.1-or-later

// The settings of a study: each knob that a motor has, and no other; and, on quick settings of the
// reference motor, a known convergence: the distance of the speed from that of a finer mesh falls
// with the degree of the elements.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/points/contact_study.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double period = 1. / 30e3;

  std::vector<ContactSetting> settings_of(const Parameters &parameters)
  {
    return contact_settings(parameters, {period, 1e7});
  }

  std::set<std::string> knobs_of(const Parameters &parameters)
  {
    std::set<std::string> knobs;
    for (const ContactSetting &setting : settings_of(parameters))
      knobs.insert(setting.knob);
    return knobs;
  }
} // namespace

TEST(ContactSettings, TurnOnlyKnobsThatTheMotorHas)
{
  const std::set<std::string> always{"common setting",
                                     "interface mesh",
                                     "degree",
                                     "cells across the lip",
                                     "cells around the tooth",
                                     "even cells across the lip",
                                     "ratio of the layers at edges",
                                     "cells at the rotor's edges",
                                     "flange",
                                     "contact",
                                     "steps per period",
                                     "best setting"};
  Parameters parameters         = reference_motor();
  std::set<std::string> uniform = always;
  uniform.insert("as in the paper");
  EXPECT_EQ(knobs_of(parameters), uniform);

  parameters.time.scheme        = TimeScheme::marching;
  std::set<std::string> marched = uniform;
  marched.insert("averaging window");
  EXPECT_EQ(knobs_of(parameters), marched);

  parameters                          = reference_motor();
  parameters.effects["Rotor inertia"] = EffectChoice::on;
  std::set<std::string> with_inertia  = always;
  with_inertia.insert({"rotor modes", "spectral radius"});
  EXPECT_EQ(knobs_of(parameters), with_inertia);
}

TEST(ContactSettings, AreAllDifferentAndEndWithTheBest)
{
  const std::vector<ContactSetting> settings = settings_of(reference_motor());
  std::set<std::string> texts;
  for (const ContactSetting &setting : settings)
    texts.insert(setting.text());
  EXPECT_EQ(texts.size(), settings.size());
  EXPECT_EQ(settings.back().knob, "best setting");
  EXPECT_EQ(settings.back().discretisation.lip.n_across, 3u);
  for (const ContactSetting &setting : settings)
  {
    EXPECT_EQ(setting.is_other_model, setting.knob == "flange");
    EXPECT_LE(setting.n_steps, settings.back().n_steps);
  }
}

TEST(ContactSettings, StayWithinAGivenDiscretisation)
{
  Parameters parameters                    = reference_motor();
  parameters.accuracy.mode                 = AccuracyMode::fixed;
  parameters.accuracy.interface_refinement = 1;
  for (const ContactSetting &setting : settings_of(parameters))
  {
    EXPECT_LE(setting.discretisation.degree, 2u);
    EXPECT_LE(setting.discretisation.lip.n_across, 2u);
    EXPECT_GE(setting.discretisation.rotor.first, 0.25);
  }
}

TEST(ContactSettings, GiveAPeriodEnoughSteps)
{
  Parameters parameters = reference_motor(); // ninety different teeth
  EXPECT_EQ(StepChoice(parameters, period).at_least(90.).n_parts, 1u);
  EXPECT_EQ(StepChoice(parameters, period).at_least(180.).n_parts, 2u);
  EXPECT_EQ(StepChoice(parameters, period).at_least(45.).n_joined, 2u);
  parameters.motor.n_waves = 9; // ten of them
  EXPECT_EQ(StepChoice(parameters, period).at_least(180.).n_parts, 18u);
  parameters.time.scheme    = TimeScheme::marching;
  parameters.time.time_step = period / 60.;
  EXPECT_EQ(StepChoice(parameters, period).at_least(240.).n_parts, 4u);
  EXPECT_EQ(StepChoice(parameters, period).at_least(30.).n_joined, 2u);
}

TEST(ContactStudy, ComesCloserToAFinerMeshWithCellsAndDegree)
{
  Parameters parameters                    = reference_motor();
  parameters.rotor.flange_element          = ElementKind::shell;
  parameters.loading.values                = {0.05};
  parameters.accuracy.mode                 = AccuracyMode::fixed;
  parameters.accuracy.interface_refinement = 2;
  const StatorWave wave                    = stator_wave(parameters);
  const MotorVibration vibration(parameters, wave);
  ContactStudy study(parameters, wave, vibration);
  std::map<std::string, StudyRow> rows;
  for (const ContactSetting &setting : study.settings())
    for (const std::string name : {"common setting ", "interface mesh 0, 180 steps", "degree 3",
                                   "interface mesh 2, 180 steps"})
      if (setting.knob + " " + setting.value == name)
        rows[name] = study.compute(setting);
  ASSERT_EQ(rows.size(), 4u);
  const WorkPrecision compared =
      study.compare({rows["interface mesh 0, 180 steps"], rows["common setting "], rows["degree 3"],
                     rows["interface mesh 2, 180 steps"]});
  ASSERT_EQ(compared.quantities().front().name, "speed");
  for (const unsigned int row : {0u, 1u, 2u})
    record("distance of speeds from the finest, mesh 0, common setting, degree 3",
           *compared.distance(row, 0));
  EXPECT_LT(*compared.distance(1, 0), *compared.distance(0, 0));
  EXPECT_LT(*compared.distance(2, 0), 0.5 * *compared.distance(1, 0));
}
