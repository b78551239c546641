// SPDX-License-Identifier: LGPL-2.1-or-later
// Implausible numbers that would be plausible in other units.

#include "sample.h"

#include <ringmotor/parameters/check_geometry.h>

#include <string>
#include <vector>

using namespace ringmotor;
using ringmotor::sample::expect_message;
using ringmotor::sample::message_of;
using ringmotor::sample::with;

TEST(Plausible, NumbersInOtherUnitsAreRefused)
{
  struct Case
  {
    std::string entry, value, guess;
  };
  for (const auto &[entry, value, guess] : std::vector<Case>{
           {"Stator/Base inner radius", "30", "(30 mm is 30e-3)"},
           {"Stator/Base thickness", "1.4", "(1.4 mm is 1.4e-3)"},
           {"Stator/Slot width", "600", "(600 um is 600e-6)"},
           {"Stator/Piezoceramic thickness", "0.5", "(0.5 mm is 0.5e-3)"},
           {"Rotor/Ring lower face", "-3", "(-3 mm is -3e-3)"},
           {"Rotor/Flange thickness", "0.6", "mm"},
           {"Rotor/Lip inner radius", "33.2", "mm"},
           {"Materials/Stator metal/Young modulus", "110", "(110 GPa is 110e9)"},
           {"Materials/Piezoceramic/Young modulus", "81000", "(81000 MPa is 81000e6)"},
           {"Materials/Rotor metal/Young modulus", "1e30", "1e+08 to 1.5e+12 Pa"},
           {"Materials/Stator metal/Density", "8.8", "(8.8 g/cm^3 is 8.8e3)"},
           {"Wave/Amplitude", "1.5", "(1.5 um is 1.5e-6)"},
           {"Wave/Frequency", "43.2", "(43.2 kHz is 43.2e3)"},
           {"Loading/Preload", "6e6", "0.001 to 100000 N"},
           {"Friction/Static coefficient", "48", "(48 % is 48e-2)"},
           {"Time/Time step", "0.5", "(0.5 us is 0.5e-6)"},
           {"Initial deformation/Amplitude", "4", "(4 um is 4e-6)"},
           {"Support/Felt outer radius", "36", "mm"}})
  {
    const std::string text = entry + " = " + value;
    expect_message(message_of([&] { with({text}); }),
                   {text, "not plausible", guess, "Motor/Unusual values = accept"});
    EXPECT_NO_THROW(with({text, "Motor/Unusual values = accept"})) << entry;
  }
  expect_message(message_of(
                     [] {
                       read_parameters_from_text("subsection Loading\n  set Preload = 6e6\nend\n",
                                                 "my.prm");
                     }),
                 {"my.prm:2: Loading/Preload"});
  EXPECT_NO_THROW(with({"Rotor/Flange lower face = 0", "Initial deformation/Amplitude = 0",
                        "Rotor/Radial bar stiffness = 0", "Wave/Frequency = mode"}));
}

TEST(Plausible, TheRingOfTheRotorClearsTheStator)
{
  StatorGeometry stator;
  stator.base_thickness    = 4e-3;
  stator.tooth_height      = 2e-3;
  stator.tip_outer_radius  = 34e-3;
  stator.base_outer_radius = 37e-3; // the side recedes by half of the height
  RotorGeometry rotor;
  rotor.ring_inner_radius = 36e-3;
  rotor.ring_lower_face   = -2e-3;
  rotor.ring_upper_face   = 5e-3;
  EXPECT_NEAR(clearance(stator, rotor), 1e-3, 1e-15);
  rotor.ring_lower_face = -4.2e-3;
  EXPECT_NEAR(clearance(stator, rotor), -0.1e-3, 1e-15);
  expect_message(message_of([&] { check_clearance(stator, rotor); }),
                 {"cuts into", "Rotor/Ring inner radius = 0.036", "above 0.0361"});
  rotor.ring_lower_face = -10e-3; // below the stator
  EXPECT_NEAR(clearance(stator, rotor), -1e-3, 1e-15);
  rotor.ring_lower_face = 3e-3; // above it
  EXPECT_NEAR(clearance(stator, rotor), std::hypot(2e-3, 3e-3), 1e-15);
  rotor.ring_inner_radius = 33e-3;
  EXPECT_NEAR(clearance(stator, rotor), 3e-3, 1e-15);
  EXPECT_NO_THROW(check_clearance(stator, rotor));
}
