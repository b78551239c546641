// SPDX-License-Identifier: LGPL-2.1-or-later

// What the stator's compliance changes, against what its indicator says, for the ring of the paper,
// a ring of 60 mm and a disc on a web. The changes are computed on a finer mesh with steps half as
// long: the indicator is to be cheap, and within a factor of three.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/points/effect_on_points.h>
#include <ringmotor/points/point_finder.h>
#include <ringmotor/points/point_quantities.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  const std::string name = "Stator compliance";

  /** A motor of prm/ with the effects that matter to all three. */
  Parameters motor_of(const std::string &file)
  {
    Parameters parameters      = read_parameters(RINGMOTOR_SOURCE_DIR "/prm/" + file + ".prm");
    parameters.accuracy.target = 1e-3;
    for (const std::string off : {"Rotor inertia", "Tooth vibration", "Damping"})
      parameters.effects[off] = EffectChoice::off;
    for (const std::string on : {"Tooth inertia", "Stator back-reaction"})
      parameters.effects[on] = EffectChoice::on;
    return parameters;
  }

  class StatorComplianceLong : public testing::TestWithParam<std::string>
  {
  protected:
    void SetUp() override
    {
      parameters = motor_of(GetParam());
      wave       = stator_wave(parameters);
      vibration.emplace(parameters, wave);
    }

    /** On interface mesh 1 with four snapshots. */
    std::vector<CurvePoint> points(const EffectChoice choice,
                                   const std::vector<PointRequest> &requests) const
    {
      Parameters chosen       = with_parts_of_a_step(parameters, 4);
      chosen.effects[name]    = choice;
      const auto modes        = ModeSets::own;
      constexpr auto level    = 1u;
      const CondensedMotor at = condense_motor(chosen, wave, ContactDiscretisation::level(level),
                                               level, &*vibration, modes);
      OperatingPointFinder finder(chosen, at);
      std::vector<CurvePoint> found;
      for (const PointRequest &request : requests)
        found.push_back(finder.find(request));
      return found;
    }

    Parameters parameters;
    StatorWave wave;
    std::optional<MotorVibration> vibration;
  };
} // namespace

TEST_P(StatorComplianceLong, ChangesPointsAsItsIndicatorSays)
{
  const EffectOnPoints says =
      EffectsOnPoints(wave, *vibration, MPI_COMM_SELF).of(effect(name), parameters);
  const CurvePoint stall = points(EffectChoice::off, {{Control::speed, 0.}}).front();
  const std::vector<PointRequest> requests{{Control::speed, 0.},
                                           {Control::torque, 0.85 * stall.result.torque},
                                           {Control::torque, 0.5 * stall.result.torque},
                                           {Control::torque, 0.}};
  const std::vector<CurvePoint> without = points(EffectChoice::off, requests),
                                with    = points(EffectChoice::on, requests);
  PointError changes;
  for (std::size_t i = 0; i < requests.size(); ++i)
    changes.raise(change(without[i], with[i]));
  const double relative = std::max(changes["speed"] / without.back().result.speed,
                                   changes["torque"] / stall.result.torque);
  const double loss     = without.back().result.friction_loss();
  record("indicator", says.relative);
  record("relative change", relative);
  record("speed without load changes by",
         with.back().result.speed / without.back().result.speed - 1.);
  record("stall torque changes by", with.front().result.torque / stall.result.torque - 1.);
  record("friction loss without load changes by", with.back().result.friction_loss() / loss - 1.);
  EXPECT_GT(says.relative, relative / 3.);
  EXPECT_LT(says.relative, relative * 3.);
  EXPECT_GT(says.largest()["friction_loss"], changes["friction_loss"] / 3.);
  EXPECT_LT(says.largest()["friction_loss"], changes["friction_loss"] * 3.);
}

INSTANTIATE_TEST_SUITE_P(Motors, StatorComplianceLong,
                         testing::Values("canon_ring", "ring60", "disc60"),
                         [](const auto &motor) { return motor.param; });
