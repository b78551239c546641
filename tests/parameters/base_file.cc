// SPDX-License-Identifier: LGPL-2.1-or-later

// Parameter files that hold only what differs from another one. Expected is what the test itself
// wrote into the files, and the precedence that is documented: command line, file, base, its base.

#include "output/scratch.h"
#include "refusal.h"

#include <fstream>

using namespace ringmotor;
using namespace ringmotor::sample;
using ringmotor::tests::Scratch;

namespace
{
  class BaseFile : public testing::Test
  {
  protected:
    BaseFile() { write("base.prm", complete_text()); }

    void write(const std::string &name, const std::string &text) const
    {
      std::filesystem::create_directories(std::filesystem::path(scratch.path(name)).parent_path());
      std::ofstream(scratch.path(name)) << text;
    }
    Parameters read(const std::string &name, const std::vector<std::string> &overrides = {}) const
    {
      return read_parameters(scratch.path(name), overrides);
    }
    void expect_refusal(const std::string &text, const std::vector<std::string> &words) const
    {
      write("my.prm", text);
      expect_message(message_of([&] { read("my.prm"); }), words);
    }

    const Scratch scratch;
  };

  std::string loading(const std::string &entry)
  {
    return "subsection Loading\n  set " + entry + "\nend\n";
  }
} // namespace

TEST_F(BaseFile, IsTakenWhereAFileSaysNothing)
{
  write("variant.prm", "set Base file = base.prm\n" + loading("Preload = 20"));
  const Parameters base = read("base.prm");
  Parameters variant    = read("variant.prm");
  EXPECT_EQ(variant.loading.preload, 20.);
  EXPECT_EQ(variant.output.directory, "output/variant");
  variant.loading = base.loading;
  variant.output  = base.output;
  EXPECT_EQ(printed(variant), printed(base));
}

TEST_F(BaseFile, TellsTheDifferences)
{
  write("variant.prm", "set Base file = base.prm\n" + loading("Preload = 20"));
  write("of/variants/second.prm", loading("Preload = 14") + "set Base file = ../../variant.prm\n" +
                                      "subsection Wave\n  set Amplitude = 3e-6\nend\n");
  const auto told = [&](const std::string &name, const std::vector<std::string> &overrides)
  {
    std::string text;
    for (const auto &[entry, value, of_base] : read(name, overrides).variant.differences)
      text += entry + " " + value + " " + of_base + "; ";
    return text;
  };
  EXPECT_EQ(told("base.prm", {"Loading/Preload = 7"}), "");
  EXPECT_EQ(told("variant.prm", {}), "Loading/Preload 20 14; ");
  EXPECT_EQ(told("variant.prm", {"Loading/Preload = 14", "Motor/Name = other"}),
            "Motor/Name other " + read("base.prm").motor.name + "; ");
  // The base at the end of the chain, and what is left of the differences from it.
  EXPECT_EQ(told("of/variants/second.prm", {}), "Wave/Amplitude 3e-06 2e-06; ");
  EXPECT_EQ(read("of/variants/second.prm").variant.base, scratch.path("base.prm"));
}

TEST_F(BaseFile, MayLackWhatTheFileGives)
{
  write("part.prm", loading("Number of curve points = 5"));
  write("my.prm", complete_text() + "set Base file = part.prm\n");
  EXPECT_EQ(read("my.prm").loading.n_curve_points, read("base.prm").loading.n_curve_points);
  expect_refusal("set Base file = part.prm\n",
                 {"my.prm: missing ", "more; the motor has no default values"});
}

TEST_F(BaseFile, FindsItsMeshBesideItself)
{
  write("folder/base.prm", complete_text());
  write("folder/a.msh", "");
  write("variant.prm", "set Base file = folder/base.prm\n");
  EXPECT_EQ(read("variant.prm", {"Stator/Mesh file = a.msh"}).stator.mesh_file,
            scratch.path("a.msh"));
  write("folder/middle.prm", "set Base file = base.prm\nsubsection Stator\n  set Mesh file = "
                             "a.msh\nend\n");
  write("variant.prm", "set Base file = folder/middle.prm\n");
  EXPECT_EQ(read("variant.prm").stator.mesh_file, scratch.path("folder/a.msh"));
}

TEST_F(BaseFile, MistakesAreToldWhereTheyAre)
{
  expect_refusal("set Base file = none.prm\n",
                 {"my.prm:1: Base file = \"none.prm\" cannot be used", "none.prm: no such",
                  "folder of the file that names it"});
  expect_refusal("set Base file = .\n", {"my.prm:1: ", "is a folder"});
  expect_refusal("set Base file =\n", {"my.prm:1: Base file", "is empty", "allowed: a path"});
  expect_refusal("set Base file = ~/base.prm\n", {"my.prm:1: Base file", "begins with ~"});
  expect_refusal("set Base file = my.prm\n", {"my.prm:1: ", "leads back to", "my.prm"});
  write("other.prm", "set Base file = my.prm\n");
  expect_refusal("set Base file = other.prm\n", {"other.prm:1: ", "leads back to", "my.prm"});
  expect_refusal("set Base file = base.prm\nset Base file = other.prm\n",
                 {"my.prm:2: Base file is set a second time", "my.prm:1"});
  expect_refusal("subsection Motor\n  set Base file = base.prm\nend\n",
                 {"my.prm:2: unknown entry \"Motor/Base file\""});
  write("wrong.prm", complete_text() + loading("Preload = heavy"));
  expect_refusal("set Base file = wrong.prm\n", {"wrong.prm:", "Loading/Preload", "second time"});
  expect_message(message_of([&] { read("base.prm", {"Base file = other.prm"}); }),
                 {"--set \"Base file = other.prm\"", "unknown entry"});
}
