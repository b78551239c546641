// SPDX-License-Identifier: LGPL-2.1-or-later

// What is reported about text that is not what it looks like: characters, encodings, commas, paths
// and backslashes.

#include "refusal.h"

#include <filesystem>
#include <fstream>

using namespace ringmotor;
using ringmotor::sample::complete_text;
using ringmotor::sample::expect_message;
using ringmotor::sample::expect_refused_override;
using ringmotor::sample::expect_refused_text;
using ringmotor::sample::message_of;
using ringmotor::sample::with;
using ringmotor::sample::Words;

TEST(WrongInput, CharactersThatDeceive)
{
  const auto expect_refused_line = [](const std::string &line, const Words &words)
  { expect_refused_text("subsection Motor\n" + line + "\nend\n", words); };
  expect_refused_line("set Number of waves\u00A0 = 7", {"my.prm:2: ", "U+00A0, a no-break space"});
  expect_refused_line("set\u00A0Number of waves = 7", {"my.prm:2: ", "U+00A0, a no-break space"});
  expect_refused_line("set Number of waves \uFF1D 7", {"my.prm:2: ", "U+FF1D, a full-width"});
  expect_refused_line("set Numb\u0435r of waves = 7", {"my.prm:2: ", "U+0435, a Cyrillic letter"});
  expect_refused_line("set N\u00FCmber of waves = 7", {"my.prm:2: ", "U+00FC", "not an ASCII"});
  expect_refused_line("\uFEFFset Number of waves = 7", {"my.prm:2: ", "U+FEFF, a byte-order mark"});
  expect_refused_override("Wave/Ampli\u200Btude = 1e-6", {"--set", "U+200B, a zero-width space"});

  for (const std::string entry :
       {"Wave/Amplitude", "Motor/Number of teeth", "Loading/Values", "Friction/Law",
        "Modes/Nodal diameters", "Wave/Frequency", "Output/VTU", "Output/Directory"})
  {
    expect_refused_override(entry + " = 14\u00A0", {entry, "U+00A0, a no-break space"});
    expect_refused_override(entry + " = 1\u200D4", {entry, "U+200D, a zero-width character"});
    expect_refused_override(entry + " = \u202E14", {entry, "U+202E, an invisible mark"});
  }
  expect_refused_override("Rotor/Ring lower face = \u22120.003",
                          {"U+2212, a minus sign", "plain -"});
  expect_refused_override("Loading/Values = 0, \u20130.05", {"U+2013, a hyphen or dash"});
  expect_refused_override("Wave/Amplitude = \uFF11e-6", {"U+FF11, a full-width character"});
  expect_refused_override("Wave/Amplitude = 1.41\u00D710-6", {"U+00D7, a multiplication sign"});
  expect_refused_override("Friction/Law = \u201Ccoulomb\u201D", {"U+201C, a curly quotation mark"});
  expect_refused_override("Wave/Amplitude = \u00BD", {"U+00BD", "not an ASCII character"});
  expect_refused_override("Friction/Law = coul\u00F6mb", {"U+00F6", "not an ASCII character"});
  expect_refused_override("Friction/Law = \"coulomb\"", {"is in quotes", "leave them out"});
  expect_refused_override("Motor/Name = a\u0085", {"Motor/Name", "U+0085, a control character"});
}

TEST(WrongInput, TextsThatAreNotUtf8)
{
  const std::string text = "# Pr\xFC"
                           "fstand\nsubsection Motor\nend\n";
  expect_refused_text(text, {"my.prm: ", "byte 0xFC in line 1", "save it as UTF-8", "iconv"});
  expect_refused_text("subsection Motor\nset Name = caf\xE9\nend\n", {"byte 0xE9 in line 2"});
  expect_refused_text("# cut off in a character \xE8\xB6", {"byte 0xE8"});
  expect_refused_override("Motor/Name = caf\xE9", {"--set \"Motor/Name = caf?\"", "byte 0xE9"});
  expect_refused_override("Output/Directory = \xFC", {"--set", "byte 0xFC, which is not UTF-8"});

  std::string little, big;
  for (const char character : complete_text())
  {
    little += {character, '\0'};
    big += {'\0', character};
  }
  expect_refused_text("\xFF\xFE" + little, {"my.prm: is in UTF-16,", "UTF-8", "iconv -f UTF-16 "});
  expect_refused_text("\xFE\xFF" + big, {"my.prm: is in UTF-16,", "UTF-8"});
  expect_refused_text(little, {"my.prm: is in UTF-16LE,", "UTF-8"});
  expect_refused_text(big, {"my.prm: is in UTF-16BE,", "UTF-8"});
  expect_refused_text(std::string("\xFF\xFE\0\0#\0\0\0", 8), {"my.prm: is in UTF-32,", "UTF-8"});
}

TEST(WrongInput, ExponentsOfOtherLanguages)
{
  const std::string entry = "Materials/Stator metal/Young modulus";
  for (const std::string exponent : {"d11", "D+11", " e11", "e 11", "q11", "e"})
    expect_refused_override(entry + " = 1.41" + exponent,
                            {entry, "the exponent \"", "write exponents as in 1.41e11"});
  for (const std::string power : {"*10^11", " x 10^11", "*10**11"})
    expect_refused_override(entry + " = 1.41" + power, {entry, "the power of ten", "1.41e11"});
  expect_refused_override("Loading/Values = 1, 2d" + std::string(1000000, '1'), {"exponent"});
  expect_refused_override("Loading/Values = 1, " + std::string(1000000, ' ') + "05",
                          {"leading zero"});
  expect_refused_override("Loading/Values = 0, 5d-2", {"Loading/Values", "the exponent \"d-2\""});
}

TEST(WrongInput, DecimalCommas)
{
  for (const std::string list : {"0,05", "1,5", "0,2, 0,3", "0.1, 1,5", "-0,05", "1,000"})
    expect_refused_override("Loading/Values = " + list,
                            {"Loading/Values", list, "comma between digits", "decimal point"});
  expect_refused_override("Loading/Values = 0, 05", {"leading zero", "decimal comma"});
  expect_refused_override("Wave/Response torques = 0,05", {"comma between digits"});
  expect_refused_override("Output/History points = 0:0,0342", {"comma between digits"});
  expect_refused_override("Accuracy/Quantities = speed:0,1", {"comma between digits"});
  expect_refused_override("Motor/Number of teeth = 9,0", {"comma between digits"});
  expect_refused_override("Wave/Frequency = 30,000", {"comma between digits", "of thousands"});
  EXPECT_EQ(with({"Loading/Values = 0, 0.05,.1,\t-1"}).loading.values,
            (std::vector<double>{0., 0.05, 0.1, -1.}));
  EXPECT_EQ(nodal_diameters_of(with({"Modes/Nodal diameters = 5,6"})),
            (std::vector<unsigned int>{5, 6}));
}

TEST(WrongInput, PathsThatOnlyAShellUnderstands)
{
  for (const std::string entry : {"Output/Directory", "Stator/Mesh file", "Rotor/Mesh file"})
  {
    expect_refused_override(entry + " = ~/x", {entry, "begins with ~", "home folder"});
    for (const std::string path : {"$HOME/x", "x/${USER}", "$(pwd)/x", "`pwd`/x"})
      expect_refused_override(entry + " = " + path, {entry, path, "only a shell"});
    for (const std::string quoted : {"\"x y\"", "'x'", "\u201Cx\u201D", "\"x"})
      expect_refused_override(entry + " = " + quoted, {entry, "quotes", "leave them out"});
    for (const std::string path : {"C:\\x", "x\\"})
      expect_refused_override(entry + " = " + path, {entry, "backslash", "by /"});
    expect_refused_override(entry + " = a#b", {entry, "has a #"});
    expect_refused_override(entry + " = file:///x", {entry, "is an address"});
    expect_refused_override(entry + " = a\u00A0b", {entry, "U+00A0"});
    expect_refused_override(entry + " = a\nb", {entry, "control character"});
  }
  EXPECT_EQ(with({"Output/Directory = Bob's r\u00FCn~1/\u8D85"}).output.directory,
            "Bob's r\u00FCn~1/\u8D85");

  // What the programs find by themselves must fit into used.prm as well.
  expect_message(message_of([] { read_parameters_from_text(complete_text(), "C#.prm"); }),
                 {"Output/Directory", "output/C#", "begins a comment", "choose another"});
  expect_message(message_of([] { read_parameters_from_text(complete_text(), "caf\xE9.prm"); }),
                 {"Output/Directory", "output/caf?", "choose another"});
  expect_message(message_of(
                     [] {
                       read_parameters_from_text(complete_text(), "/C#/a.prm",
                                                 {"Stator/Mesh file = a.msh"});
                     }),
                 {"Stator/Mesh file", "/C#/a.msh", "choose another"});
}

TEST(WrongInput, BackslashesThatSwallowALine)
{
  for (const std::string next : {"set Frames per period = 8", "end", "subsection Motor"})
    expect_refused_text("subsection Output\n  set Directory = results\\\n  " + next + "\nend\n",
                        {"my.prm:2: ", "backslash", "the next line, \"" + next, "remove"});
}
