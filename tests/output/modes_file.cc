// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Which wave is accepted for which motor: a change of any entry that the wave can depend on is
// refused, with its name and both values; no other entry matters. The lists here are the promise to
// the user, not taken from the program.

#include "output/scratch.h"
#include "parameters/sample.h"

#include <ringmotor/output/modes_file.h>
#include <ringmotor/output/stator_files.h>
#include <ringmotor/parameters/prm_file.h>
#include <ringmotor/wave/body_modes.h>

#include <gtest/gtest.h>

#include <set>

using namespace ringmotor;
using namespace ringmotor::tests;
using ringmotor::sample::changed;
using ringmotor::sample::expect_message;
using ringmotor::sample::message_of;
using ringmotor::sample::with;

namespace
{
  StatorWave wave_of(const std::string &path, const Parameters &parameters)
  {
    return ModesFile(path, parameters).wave();
  }

  /** All entries of these sections except those below, and single entries of others. */
  bool is_of_the_wave(const std::string &entry)
  {
    static const std::set<std::string> excepted{"Motor/Name",
                                                "Motor/Unusual values",
                                                "Materials/Stator metal/Loss factor",
                                                "Materials/Piezoceramic/Loss factor",
                                                "Materials/Target plate/Loss factor",
                                                "Stator/Slot angle",
                                                "Materials/Lining/Young modulus",
                                                "Materials/Lining/Poisson ratio",
                                                "Materials/Lining/Density",
                                                "Materials/Lining/Loss factor",
                                                "Materials/Adhesive/Young modulus",
                                                "Materials/Adhesive/Poisson ratio",
                                                "Materials/Adhesive/Density",
                                                "Materials/Adhesive/Loss factor",
                                                "Materials/Rotor metal/Young modulus",
                                                "Materials/Rotor metal/Poisson ratio",
                                                "Materials/Rotor metal/Density",
                                                "Materials/Rotor metal/Loss factor"};
    static const std::set<std::string> added{"Wave/Amplitude", "Wave/Frequency",
                                             "Effects/Target plates", "Effects/Felt support",
                                             "Effects/Piezoelectric coupling"};
    const std::string section = entry.substr(0, entry.find('/'));
    return added.count(entry) > 0 ||
           ((section == "Motor" || section == "Stator" || section == "Materials") &&
            excepted.count(entry) == 0);
  }

  /** Matters only if the plates are included. */
  bool is_of_the_plates(const std::string &entry)
  {
    return entry == "Stator/Target plate cross-section" ||
           entry.find("Materials/Target plate/") == 0;
  }

  class ModesFileOwner : public testing::TestWithParam<EffectChoice>
  {
  protected:
    /** Writes `modes.h5` of a motor, from a coarse mesh. */
    void write(Parameters parameters) const
    {
      parameters.accuracy.mode              = AccuracyMode::fixed;
      parameters.accuracy.polynomial_degree = 2;
      BodyModes body(parameters, MPI_COMM_SELF);
      body.find([](const Pass &) {});
      write_modes_h5(path, parameters, body.search().sector(), body.search().modes(), body.wave());
    }

    std::string refusal(const Parameters &parameters) const
    {
      return message_of([&]() { read_stator_wave(ModesFile(path, parameters), parameters); });
    }

    const Scratch scratch;
    const std::string path = scratch.path("modes.h5");
  };
} // namespace

TEST_P(ModesFileOwner, IsToldByEveryEntryThatTheWaveDependsOn)
{
  const bool has_plates          = GetParam() == EffectChoice::on;
  Parameters motor               = with({});
  motor.effects["Target plates"] = GetParam();
  write(motor);
  EXPECT_GT(ModesFile(path, motor).wave().angular_frequency, 0.);

  unsigned int n_refused = 0, n_accepted = 0;
  const auto values_of = [](const Parameters &parameters)
  { return parse_prm(text_of(parameters), "values").assignments; };
  const std::vector<PrmFile::Assignment> values = values_of(motor);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const std::string &entry = values[i].path;
    const std::string change = changed(entry);
    ASSERT_NE(change, "") << entry << ": the test knows no other value";
    Parameters other               = with({change});
    other.effects["Target plates"] = entry != "Effects/Target plates" ? GetParam()
                                     : has_plates                     ? EffectChoice::off
                                                                      : EffectChoice::on;
    if (entry == "Wave/Drive") // which the file of a ceramic without a potential does not serve
      expect_message(refusal(other), {path + " has no circuits of the phases", entry});
    else if (is_of_the_wave(entry) && (has_plates || !is_of_the_plates(entry)))
    {
      expect_message(refusal(other), {path + " belongs to another motor: " + entry + " = " +
                                      values[i].value + " there, " + values_of(other)[i].value +
                                      " here; run the program stator with these parameters first"});
      ++n_refused;
    }
    else
    {
      EXPECT_NO_THROW(ModesFile(path, other).wave()) << change;
      ++n_accepted;
    }
  }
  EXPECT_EQ(n_refused, has_plates ? 28u : 24u);
  EXPECT_GT(n_accepted, 60u);
}

INSTANTIATE_TEST_SUITE_P(TargetPlates, ModesFileOwner,
                         testing::Values(EffectChoice::off, EffectChoice::on));

class ModesFileCeramic : public ModesFileOwner
{
};

// The entries of the ceramic and of its electrodes matter where it has a potential, losses never.
TEST_F(ModesFileCeramic, IsToldByItsEntries)
{
  const std::string on = "Effects/Piezoelectric coupling = on";
  write(with({on}));
  for (const std::string entry : {"Piezoelectricity/Stiffness c11", "Piezoelectricity/Coupling 15",
                                  "Electrodes/Distance of phases", "Electrodes/Arcs of phase A"})
    expect_message(refusal(with({on, entry + (entry[0] == 'P' ? " = 13e10" : " = 1")})), {entry});
  EXPECT_NO_THROW(wave_of(path, with({on, "Piezoelectricity/Dielectric loss factor = 0.02"})));
}

class ModesFileMesh : public ModesFileOwner
{
};

TEST_F(ModesFileMesh, CountsByItsContentNotByItsPlace)
{
  const std::string source = std::string(RINGMOTOR_SOURCE_DIR) + "/meshes/canon_half_sector.msh";
  const std::string here = scratch.path("here.msh"), there = scratch.path("there.msh");
  std::filesystem::copy_file(source, here);
  std::filesystem::copy_file(source, there);
  const auto motor = [](const std::string &mesh) { return with({"Stator/Mesh file = " + mesh}); };
  write(motor(here));
  EXPECT_NO_THROW(wave_of(path, motor(here)));
  EXPECT_NO_THROW(wave_of(path, motor(there)));
  expect_message(refusal(with({})), {"Stator/Mesh file = content ", " there, none here"});
  std::ofstream(here, std::ios::app) << "\n";
  expect_message(refusal(motor(here)), {"Stator/Mesh file = content ", " there, content "});
  EXPECT_NO_THROW(wave_of(path, motor(there)));
}

TEST_F(ModesFileMesh, WithoutTheWaveIsRefused)
{
  write(with({"Modes/Nodal diameters = 6"}));
  expect_message(refusal(with({})),
                 {path, "none of them is the wave of the motor (7 waves",
                  "Modes/Nodal diameters must include 7", "Modes/Number of modes"});
}
