// SPDX-License-Identifier: LGPL-2.1-or-later

// The frequency of the wave with the rotor on it: its shift is that of Rayleigh's quotient, work of
// the forces over four times the strain energy, both from the fields alone; without inertia, speeds
// are proportional to the frequency.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/motor/effect.h>
#include <ringmotor/points/point_finder.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

using namespace ringmotor;
using namespace ringmotor::tests;

TEST(StatorBackReaction, TunesTheWaveAsRayleighSays)
{
  Parameters parameters                      = reference_motor();
  parameters.effects["Stator back-reaction"] = EffectChoice::on;
  const StatorWave wave                      = stator_wave(parameters);
  const CondensedMotor motor = condense_motor(parameters, wave, ContactDiscretisation::level(0));
  parameters.effects["Stator back-reaction"] = EffectChoice::off;
  for (const double torque : {0., 0.1})
  {
    const CurvePoint given =
        OperatingPointFinder(parameters, motor).find({Control::torque, torque});
    Parameters following                      = parameters;
    following.effects["Stator back-reaction"] = EffectChoice::on;
    const CurvePoint own = OperatingPointFinder(following, motor).find({Control::torque, torque});
    // The work of the forces on the rotor in the motion of the stator's wave, at one time sample.
    double work                = 0.;
    const unsigned int n_nodes = motor.nodes.size();
    for (unsigned int i = 0; i < given.fields.state.force.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        work += given.fields.state.force[i][c] *
                (motor.wave.free_motion[i % n_nodes][c] *
                 std::polar(1., motor.wave.angular_frequency * given.fields.times[0] -
                                    2. * M_PI * 7. / 90. * (i / n_nodes)))
                    .real();
    const double shift = work / (4. * wave.strain_energy);
    record("shift of the frequency at 0, 100 mN m (Hz)", 30e3 * shift);
    EXPECT_NEAR(given.result.detuning, shift, 1e-9 * shift);
    // An independent estimate for this motor is about 100 Hz.
    EXPECT_GT(30e3 * shift, 50.);
    EXPECT_LT(30e3 * shift, 150.);
    for (const auto &effect : all_effects())
      if (effect->name == "Stator back-reaction")
      {
        EXPECT_NEAR(*effect->indicator({parameters, &wave, {}}), shift, 0.1 * shift);
      }
    // Static compliance and friction are rate-independent: all speeds increase in proportion.
    EXPECT_NEAR(own.result.speed / given.result.speed, 1. + shift, 1e-6);
    EXPECT_NEAR(own.result.friction_loss() / given.result.friction_loss(), 1. + shift, 1e-5);
  }
}

TEST(StatorBackReaction, FollowsTheFrequencyOfTheWaveWithInertia)
{
  Parameters parameters               = reference_motor();
  parameters.loading.preload          = 40.;
  parameters.effects["Rotor inertia"] = EffectChoice::on;
  parameters.effects["Damping"]       = EffectChoice::on;
  const StatorWave wave               = stator_wave(parameters);
  CondensedMotor motor = condense_motor(parameters, wave, ContactDiscretisation::level(0), 1);
  Parameters following = parameters;
  following.effects["Stator back-reaction"] = EffectChoice::on;
  const PointRequest request{Control::torque, 0.};
  const CurvePoint own = OperatingPointFinder(following, motor).find(request);
  const double shift   = own.result.detuning;
  record("relative shift of the frequency", shift);
  EXPECT_GT(shift, 5e-3);
  motor.wave.angular_frequency *= 1. + shift;
  const CurvePoint given = OperatingPointFinder(parameters, motor).find(request);
  EXPECT_NEAR(given.result.detuning, shift, 1e-6 * shift);
  EXPECT_NEAR(given.result.speed, own.result.speed, 1e-6 * own.result.speed);
}
