// SPDX-License-Identifier: LGPL-2.1-or-later

// Entries that a file does not give: what they stand for is what doc/parameters.md says of parts
// that a motor does not have, of the constants of the ceramic, and of laws with one coefficient.

#include "sample.h"

#include <algorithm>

using namespace ringmotor;
using ringmotor::sample::complete_text;

namespace
{
  const std::string source_folder = RINGMOTOR_SOURCE_DIR;
}

TEST(Reading, HasNoPartThatAFileDoesNotName)
{
  const Parameters stator = read_parameters_from_text(
      "subsection Motor\n set Number of waves = 7\n set Number of teeth = 90\nend\n"
      "subsection Stator\n set Mesh file = " +
          source_folder +
          "/meshes/canon_half_sector.msh\nend\n"
          "subsection Materials\n"
          " subsection Stator metal\n"
          "  set Young modulus = 141e9\n set Poisson ratio = 0.29\n set Density = 8100\n end\n"
          " subsection Piezoceramic\n"
          "  set Young modulus = 81e9\n set Poisson ratio = 0.31\n set Density = 7600\n end\nend\n"
          "subsection Wave\n set Amplitude = 2e-6\nend\n",
      "stator.prm");
  EXPECT_FALSE(stator.support.has_felt());
  EXPECT_EQ(stator.support.stiffness(), 0.);
  EXPECT_EQ(stator.effects["Target plates"], EffectChoice::off);
  EXPECT_EQ(stator.effects["Piezoelectric coupling"], EffectChoice::off); // no constants
  EXPECT_EQ(read_parameters(source_folder + "/prm/canon_ring_driven.prm")
                .effects["Piezoelectric coupling"],
            EffectChoice::on);
  // Others of the rotor, its load and its friction are missing, and so are the losses.
  for (const std::string path : {"Friction/Static coefficient", "Friction/Dynamic coefficient",
                                 "Loading/Preload", "Materials/Stator metal/Loss factor",
                                 "Materials/Target plate/Density", "Piezoelectricity/Coupling 33"})
    EXPECT_EQ(std::count(stator.not_given.begin(), stator.not_given.end(), path), 1) << path;
}

TEST(Reading, SomeConstantsOfTheCeramicLeaveTheChoiceToTheProgram)
{
  const Parameters some =
      read_parameters(source_folder + "/prm/canon_ring.prm", {"Piezoelectricity/Coupling 33 = 15"});
  EXPECT_EQ(some.effects["Piezoelectric coupling"], EffectChoice::automatic);
}

TEST(Reading, OneCoefficientOfFrictionIsThatOfStickingNodes)
{
  std::string text       = complete_text();
  const std::size_t line = text.find("set Static coefficient");
  text.erase(line, text.find('\n', line) - line);
  const Parameters coulomb = read_parameters_from_text(
      text, "a.prm", {"Friction/Law = coulomb", "Friction/Dynamic coefficient = 0.3"});
  EXPECT_EQ(coulomb.friction.static_coefficient, 0.3);
  EXPECT_NO_THROW(check_for_contact(coulomb));
  EXPECT_THROW(check_for_contact(read_parameters_from_text(text, "a.prm")), UserError);
}
