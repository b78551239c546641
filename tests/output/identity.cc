// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What identifies results for scripts, which reuse them.

#include "parameters/sample.h"
#include "scratch.h"

#include <ringmotor/motor/relevant.h>
#include <ringmotor/output/files.h>
#include <ringmotor/parameters/entries.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace ringmotor;
using namespace ringmotor::tests;
using ringmotor::sample::changed;
using ringmotor::sample::with;

TEST(Identity, HoldsEveryEntryButThoseThatMakeNoDifference)
{
  const std::set<std::string> of_the_run{"Motor/Name",
                                         "Motor/Unusual values",
                                         "Uncertainty/Loss factors",
                                         "Uncertainty/Friction",
                                         "Uncertainty/Young moduli",
                                         "Accuracy/Time limit",
                                         "Output/Directory",
                                         "Output/Figures"};
  // The program stator reads none of these.
  const std::vector<std::string> after_the_wave{"Rotor/",
                                                "Materials/Rotor metal/",
                                                "Materials/Lining/",
                                                "Materials/Adhesive/",
                                                "Loading/",
                                                "Friction/",
                                                "Contact/",
                                                "Initial deformation/",
                                                "Time/",
                                                "Effects/",
                                                "Wave/Drive",
                                                "Wave/Voltage",
                                                "Wave/Response torques",
                                                "Output/History points"};
  const std::set<std::string> effects_of_the_wave{"Effects/Target plates", "Effects/Felt support",
                                                  "Effects/Piezoelectric coupling"};
  const auto is_after_the_wave = [&](const std::string &entry)
  {
    return effects_of_the_wave.count(entry) == 0 &&
           std::any_of(after_the_wave.begin(), after_the_wave.end(),
                       [&](const std::string &start) { return entry.rfind(start, 0) == 0; });
  };
  const Identity reference = identity_of(with({}), "1");
  EXPECT_EQ(identity_of(with({}), "1").motor, reference.motor);
  EXPECT_NE(identity_of(with({}), "2").motor, reference.motor);
  EXPECT_NE(identity_of(with({}), "2").wave, reference.wave);
  for (const auto &[entry, value] : entries_of(with({})))
  {
    const std::string change = changed(entry);
    const Identity other     = identity_of(with({change}), "1");
    EXPECT_EQ(other.motor != reference.motor, of_the_run.count(entry) == 0) << change;
    EXPECT_EQ(other.wave != reference.wave,
              of_the_run.count(entry) == 0 && !is_after_the_wave(entry))
        << change;
  }
}

TEST(Identity, HoldsTheContentOfMeshFilesAndNotTheirPaths)
{
  const Scratch scratch;
  const auto identity =
      [&](const std::string &entry, const std::string &name, const std::string &content)
  {
    write_file(scratch.path(name), content);
    return identity_of(with({entry + " = " + scratch.path(name)}), "1");
  };
  for (const std::string entry : {"Stator/Mesh file", "Rotor/Mesh file"})
  {
    const Identity reference = identity(entry, "a.msh", "some"),
                   other     = identity(entry, "a.msh", "other");
    EXPECT_EQ(identity(entry, "b.msh", "some").motor, reference.motor) << entry;
    EXPECT_NE(other.motor, reference.motor) << entry;
    EXPECT_EQ(other.wave != reference.wave, entry == "Stator/Mesh file") << entry;
  }
}
