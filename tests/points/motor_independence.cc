// SPDX-License-Identifier: LGPL-2.1-or-later

// Results must not depend on the constants of the method, the units, the choice of the first tooth,
// the position of the lip's mesh relative to the teeth, or the number of ranks. And a motor whose
// numbers of waves and teeth have a common factor, solved on its repeating part and in full.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/motor/marching.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/output/kept_file.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/point_finder.h>
#include <ringmotor/points/point_source.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  class NothingKept : public PointStore
  {
    std::optional<TimedMotor> recall_motor(const unsigned int,
                                           const std::optional<unsigned int> &) override
    {
      return {};
    }
    void keep_motor(const unsigned int, const std::optional<unsigned int> &,
                    const CondensedMotor &) override
    {
    }
    std::unique_ptr<PointMemory> points(const Parameters &, const Discretisation &) override
    {
      return nullptr;
    }
  };

  constexpr double rpm = M_PI / 30.;

  ContactDiscretisation coarse()
  {
    return ContactDiscretisation::level(0);
  }

  double speed_of(const Parameters &parameters, const CondensedMotor &motor, const double torque,
                  const unsigned int n_samples = 1)
  {
    return OperatingPointFinder(with_parts_of_a_step(parameters, n_samples), motor)
        .find({Control::torque, torque})
        .result.speed;
  }
} // namespace

TEST(MotorIndependence, OfTheMethodsConstants)
{
  const Parameters parameters = reference_motor();
  CondensedMotor motor        = condense_motor(parameters, stator_wave(parameters), coarse());
  const double speed          = speed_of(parameters, motor, 0.08);
  const ComplementarityConstants right = motor.constants;
  unsigned int n_solved                = 0;
  for (const double normal : {1e-2, 1., 1e2})
    for (const double tangential : {1e-2, 1., 1e2})
    {
      motor.constants = {normal * right.normal, tangential * right.tangential};
      try
      {
        EXPECT_NEAR(speed_of(parameters, motor, 0.08), speed, 1e-7 * speed);
        ++n_solved;
      }
      catch (const ComputationError &)
      {
        // A refusal is acceptable, a wrong speed is not.
      }
    }
  record("pairs of constants, of 9, that find the solution", n_solved);
  EXPECT_GT(n_solved, 0u);
}

TEST(MotorIndependence, OfUnits)
{
  const Parameters metres = reference_motor();
  const StatorWave wave   = stator_wave(metres);
  // Millimetre, newton, megapascal: the same motor in other units.
  constexpr double length = 1e3;
  Parameters millimetres  = metres;
  for (double StatorGeometry::*size :
       {&StatorGeometry::base_inner_radius, &StatorGeometry::base_outer_radius,
        &StatorGeometry::tip_inner_radius, &StatorGeometry::tip_outer_radius,
        &StatorGeometry::base_thickness, &StatorGeometry::tooth_height, &StatorGeometry::slot_width,
        &StatorGeometry::piezoceramic_thickness})
    millimetres.stator.*size *= length;
  for (double RotorGeometry::*size :
       {&RotorGeometry::ring_inner_radius, &RotorGeometry::ring_outer_radius,
        &RotorGeometry::ring_lower_face, &RotorGeometry::ring_upper_face,
        &RotorGeometry::flange_lower_face, &RotorGeometry::flange_thickness,
        &RotorGeometry::lip_inner_radius, &RotorGeometry::lip_outer_radius,
        &RotorGeometry::radial_bar_height})
    millimetres.rotor.*size *= length;
  millimetres.rotor.radial_bar_stiffness /= length * length;
  for (Material *material :
       {&millimetres.materials.stator_metal, &millimetres.materials.rotor_metal})
    material->young_modulus /= length * length;
  const auto scaled = [](const WaveMotion &motion)
  {
    return [motion](const dealii::Point<3> &x)
    {
      auto u = motion(dealii::Point<3>(x / length));
      for (auto &component : u)
        component *= length;
      return u;
    };
  };
  StatorWave wave_in_millimetres = wave;
  wave_in_millimetres.foot       = scaled(wave.foot);
  wave_in_millimetres.top        = scaled(wave.top);
  const double speed             = speed_of(metres, condense_motor(metres, wave, coarse()), 0.08);
  EXPECT_NEAR(speed_of(millimetres, condense_motor(millimetres, wave_in_millimetres, coarse()),
                       0.08 * length),
              speed, 1e-6 * speed);
}

TEST(MotorIndependence, OfTheFirstTooth)
{
  const Parameters parameters = reference_motor();
  CondensedMotor motor        = condense_motor(parameters, stator_wave(parameters), coarse());
  const double speed          = speed_of(parameters, motor, 0.08);
  for (auto &motion : motor.wave.free_motion)
    for (std::complex<double> &component : motion)
      component *= std::polar(1., -motor.n_waves * motor.pitch());
  EXPECT_NEAR(speed_of(parameters, motor, 0.08), speed, 1e-8 * speed);
}

TEST(MotorIndependence, OfHowTheMeshesLie)
{
  const Parameters parameters = reference_motor();
  const StatorWave wave       = stator_wave(parameters);
  const double speed = speed_of(parameters, condense_motor(parameters, wave, coarse()), 0.08);
  for (const double share : {0.1, 0.25, 0.5})
  {
    ContactDiscretisation turned = coarse();
    turned.lip_turn              = share * 2. * M_PI / 90.;
    // The coarsest meshes differ from the limit by 0.8 %.
    EXPECT_NEAR(speed_of(parameters, condense_motor(parameters, wave, turned), 0.08), speed,
                0.005 * speed)
        << share;
  }
}

TEST(MotorIndependence, OfHowACommonFactorIsUsed)
{
  // 9 waves, 90 teeth: the solution repeats after ten teeth. Marching does not exploit that.
  Parameters parameters            = reference_motor();
  parameters.motor.n_waves         = 9;
  parameters.modes.nodal_diameters = {9};
  const CondensedMotor motor       = condense_motor(parameters, stator_wave(parameters), coarse());
  constexpr unsigned int n_samples = 4;
  const double speed               = speed_of(parameters, motor, 0.05, n_samples);
  MarchingDriver driver(motor, parameters.friction, Warp(), 14.);
  const double step = motor.period() / (10 * n_samples);
  double mean       = 0.;
  for (unsigned int number = 0; number < 80; ++number)
  {
    const OperatingState state = driver.step({14., {}, speed}, step);
    if (number >= 40)
      mean += state.contact->torque(state.solution.state) / 40.;
  }
  EXPECT_NEAR(mean, 0.05, 1e-5);
}

TEST(MotorIndependenceRanks, SameResultsOnTwo)
{
  Parameters parameters      = reference_motor();
  parameters.loading.values  = {0., 0.05, 0.1, 0.15, 0.17};
  const CondensedMotor motor = condense_motor(parameters, stator_wave(parameters), coarse());
  const std::vector<PointRequest> requests = listed_points(parameters.loading);
  const auto curve_on                      = [&](MPI_Comm communicator) {
    return find_points({{parameters, motor, {}, {}, requests}}, communicator).front();
  };
  const std::vector<CurvePoint> one = curve_on(MPI_COMM_SELF), two = curve_on(MPI_COMM_WORLD);
  ASSERT_EQ(one.size(), 5u);
  ASSERT_EQ(two.size(), 5u);
  for (unsigned int i = 0; i < one.size(); ++i)
  {
    EXPECT_NEAR(two[i].result.speed, one[i].result.speed, 1e-7 * one[0].result.speed) << i;
    EXPECT_NEAR(two[i].result.torque, one[i].result.torque, 1e-9) << i;
    EXPECT_EQ(two[i].fields.state.force.size(), one[i].fields.state.force.size()) << i;
  }
}

TEST(MotorIndependence, BodiesThatEffectsShareAreTheirOwn)
{
  // Condensed one after the other with what all of them share, and each alone.
  Parameters parameters = reference_motor();
  const StatorWave wave = stator_wave(parameters);
  const auto coarsest   = ContactDiscretisation::level(0);
  const MotorVibration vibration(parameters, wave);
  std::set<std::string> different;
  for (const bool is_first : {true, false})
    for (const EffectChoice teeth : {EffectChoice::on, EffectChoice::off})
      for (const EffectChoice along : {EffectChoice::on, EffectChoice::off})
      {
        parameters.effects["Tooth inertia"]               = teeth;
        parameters.effects["Rotor tangential compliance"] = along;
        const auto shared = to_bytes(condense_motor(parameters, wave, coarsest, {}, &vibration));
        EXPECT_TRUE(shared ==
                    to_bytes(condense_motor(parameters, wave, coarsest))) // bytes are unreadable
            << is_first << " " << static_cast<int>(teeth) << static_cast<int>(along);
        different.insert(shared);
      }
  EXPECT_EQ(different.size(), 4u);
}

TEST(MotorIndependenceRanks, SameVibrationsAndMotorsOnTwo)
{
  Parameters parameters               = reference_motor();
  parameters.effects["Rotor inertia"] = EffectChoice::on;
  const StatorWave wave               = stator_wave(parameters);
  const MotorVibration one(parameters, wave), two(parameters, wave, MPI_COMM_WORLD);
  unsigned int n_modes = 0;
  for (unsigned int k = 0; k <= parameters.motor.n_teeth / 2; ++k)
  {
    const auto &alone  = one.rotor.of_harmonics(6, 1).of_diameter(k),
               &shared = two.rotor.of_harmonics(6, 1).of_diameter(k);
    ASSERT_EQ(alone.size(), shared.size()) << k;
    n_modes += alone.size();
    for (unsigned int i = 0; i < alone.size(); ++i)
      EXPECT_NEAR(shared[i].angular_frequency, alone[i].angular_frequency,
                  1e-10 * alone[i].angular_frequency)
          << k;
  }
  EXPECT_GT(n_modes, 20u);

  const auto motors_on = [&](const MotorVibration &vibration, MPI_Comm communicator)
  {
    NothingKept store;
    Progress silent;
    return ComputedPoints(parameters, wave, vibration, store, silent, communicator)
        .motors({0, 1}, 1);
  };
  const std::vector<TimedMotor> alone  = motors_on(two, MPI_COMM_SELF),
                                shared = motors_on(two, MPI_COMM_WORLD);
  ASSERT_EQ(shared.size(), 2u);
  for (unsigned int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(to_bytes(shared[i].motor), to_bytes(alone[i].motor)) << i;
    EXPECT_GT(shared[i].seconds, 0.);
  }
}
