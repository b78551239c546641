// SPDX-License-Identifier: LGPL-2.1-or-later

// What is reported about a mistake: the place, the entry, what was found and what is allowed, in
// one line. Each test writes the mistake and checks for the words that identify it.

#include "refusal.h"

#include <filesystem>
#include <fstream>

using namespace ringmotor;
using ringmotor::sample::complete_text;
using ringmotor::sample::expect_message;
using ringmotor::sample::expect_refused_override;
using ringmotor::sample::expect_refused_text;
using ringmotor::sample::message_of;
using ringmotor::sample::printed;
using ringmotor::sample::with;
using ringmotor::sample::Words;

namespace
{
  /** complete_text() without the line that sets @p entry in @p subsection. */
  std::string text_without(const std::string &subsection, const std::string &entry)
  {
    std::string text = complete_text();
    const auto begin = text.find("set " + entry, text.find("subsection " + subsection + "\n"));
    return text.erase(begin, text.find('\n', begin) - begin);
  }

  unsigned int n_lines(const std::string &text, const std::string &words)
  {
    std::istringstream stream(text);
    unsigned int number = 0;
    for (std::string line; std::getline(stream, line);)
      number += line.find(words) != std::string::npos;
    return number;
  }

  void expect_clash(const std::vector<std::string> &overrides, const Words &words)
  {
    const Parameters parameters = with(overrides);
    expect_message(message_of([&] { check_for_stator(parameters); }), words);
  }
} // namespace

TEST(WrongInput, UnknownEntriesAndSections)
{
  expect_refused_text("subsection Motor\n  set Number of tooth = 9\nend\n",
                      {"my.prm:2: ", "\"Motor/Number of tooth\"", "Motor/Number of teeth?"});
  expect_refused_text("subsection Stator\n  set Number of teeth = 9\nend\n",
                      {"my.prm:2: ", "\"Stator/Number of teeth\"", "mean Motor/Number of teeth?"});
  expect_refused_text("subsection Motor\n  set Colour = red\nend\n",
                      {"my.prm:2: ", "Motor/Colour", "Number of waves", "Number of teeth"});
  expect_refused_text("set Number of teeth = 90\n",
                      {"my.prm:1: ", "\"Number of teeth\"", "mean Motor/Number of teeth?"});
  expect_refused_text("# text\n\nsubsection Stater\nend\n",
                      {"my.prm:3: ", "subsection \"Stater\"", "mean Stator?"});
  expect_refused_text("subsection Motor\nsubsection Stator\nend\nend\n",
                      {"my.prm:2: ", "Motor/Stator", "mean Stator?", "end"});
  expect_refused_text("subsection Geometry\nend\n", {"Geometry", "Motor", "Stator", "Output"});
  expect_refused_override("Wave/Amplitud = 1e-6", {"--set", "mean Wave/Amplitude?"});
  expect_refused_override("Amplitude = 1e-6", {"--set", "unknown entry \"Amplitude\"", "Wave/"});
}

TEST(WrongInput, DuplicateEntries)
{
  expect_refused_text("subsection Wave\n set Amplitude = 1e-6\n set Amplitude = 2e-6\nend\n",
                      {"my.prm:3: ", "Wave/Amplitude", "my.prm:2"});
  expect_refused_text("subsection Wave\n set Amplitude = 1e-6\nend\n"
                      "subsection Wave\n set Amplitude = 1e-6\nend\n",
                      {"my.prm:5: ", "Wave/Amplitude", "my.prm:2"});
  expect_message(message_of(
                     [] {
                       with({"Wave/Amplitude = 1e-6", "Wave/Amplitude = 2e-6"});
                     }),
                 {"Wave/Amplitude", "Wave/Amplitude = 1e-6", "Wave/Amplitude = 2e-6", "remove"});
}

TEST(WrongInput, MissingEntries)
{
  const auto expect_missing = [](const std::string &subsection, const std::string &entry,
                                 const std::string &path) {
    expect_refused_text(text_without(subsection, entry), {"my.prm: missing", path});
  };
  expect_missing("Motor", "Number of waves", "Motor/Number of waves");
  expect_missing("Motor", "Number of teeth", "Motor/Number of teeth");
  expect_missing("Wave", "Amplitude", "Wave/Amplitude");
  for (const std::string entry :
       {"Base inner radius", "Base outer radius", "Tip inner radius", "Tip outer radius",
        "Base thickness", "Tooth height", "Slot width", "Piezoceramic thickness"})
    expect_missing("Stator", entry, "Stator/" + entry);
  for (const std::string material : {"Stator metal", "Piezoceramic"})
    for (const std::string entry : {"Young modulus", "Poisson ratio", "Density"})
      expect_missing(material, entry, "Materials/" + material + "/" + entry);
  expect_refused_text("", {"my.prm: missing", "more"});
}

TEST(WrongInput, RotorsThatAreMissing)
{
  // The stator alone needs none of them, and does not report another motor's.
  for (const auto &[section, entry] :
       std::vector<std::pair<std::string, std::string>>{{"Rotor", "Lip inner radius"},
                                                        {"Rotor", "Radial bar stiffness"},
                                                        {"Rotor metal", "Density"},
                                                        {"Loading", "Preload"}})
  {
    const Parameters parameters = read_parameters_from_text(text_without(section, entry), "my.prm");
    EXPECT_NO_THROW(check_for_stator(parameters)) << entry;
    EXPECT_EQ(n_lines(printed(parameters), "set " + entry),
              n_lines(complete_text(), "set " + entry) - 1);
    expect_message(message_of([&] { check_for_contact(parameters); }),
                   {"missing", entry, "--help"});
    Parameters of_rotor = parameters;
    of_rotor.modes.body = Body::rotor;
    if (section != "Loading")
      expect_message(message_of([&] { check_for_stator(of_rotor); }), {"missing", entry, "rotor"});
  }
  // Without bars their height does not matter.
  EXPECT_NO_THROW(check_for_contact(read_parameters_from_text(
      text_without("Rotor", "Radial bar height"), "my.prm", {"Rotor/Radial bar stiffness = 0"})));
}

TEST(WrongInput, WavesThatAreNotAskedFor)
{
  expect_message(message_of([] { check_for_contact(with({"Modes/Nodal diameters = 5-6"})); }),
                 {"Modes/Nodal diameters", "Motor/Number of waves = 7", "allowed: wave"});
  EXPECT_NO_THROW(check_for_contact(with({"Modes/Nodal diameters = all"})));
}

TEST(WrongInput, APartThatIsLeftOutNeedsNoMaterial)
{
  EXPECT_NO_THROW(read_parameters_from_text(text_without("Piezoceramic", "Density"), "my.prm",
                                            {"Stator/Piezoceramic thickness = 0"}));
}

TEST(WrongInput, WrongTypes)
{
  expect_refused_text("subsection Motor\n  set Number of teeth = many\nend\n",
                      {"my.prm:2: Motor/Number of teeth = \"many\"", "whole number from 3"});
  expect_refused_override("Motor/Number of teeth = 90.5",
                          {"Motor/Number of teeth", "90.5", "whole number from 3"});
  expect_refused_override("Stator/Base thickness = thick",
                          {"Stator/Base thickness", "thick", "number above 0"});
  expect_refused_override("Output/VTU = maybe", {"Output/VTU", "maybe", "true | false"});
  expect_refused_override("Effects/Damping = yes", {"Effects/Damping", "off | on | auto"});
  expect_refused_override("Stator/Piezoceramic element = beam", {"beam", "solid | shell"});
  expect_refused_override("Modes/Body = lens", {"Modes/Body", "lens", "stator | rotor | tooth"});
  for (const std::string text :
       {"5-2", "7, 5-2", "seven", "1-", "-1", "1,,2", "1;2", "0-99999999999"})
    expect_refused_override("Modes/Nodal diameters = " + text,
                            {"Modes/Nodal diameters", text, "all, or whole numbers and ranges"});
  expect_refused_override("Loading/Values = 0, fast", {"Loading/Values", "curve, or numbers"});
  expect_refused_override("Wave/Frequency = fast", {"Wave/Frequency", "mode, or a number"});
}

TEST(WrongInput, ValuesOutOfRange)
{
  for (const std::string number : {"0", "-1", "2", "10001"})
    expect_refused_override("Motor/Number of teeth = " + number,
                            {"Motor/Number of teeth", number, "from 3 to 10000"});
  expect_refused_override("Motor/Number of waves = 0", {"Motor/Number of waves", "from 1"});
  for (const std::string entry :
       {"Stator/Base inner radius", "Stator/Base outer radius", "Stator/Tip inner radius",
        "Stator/Tip outer radius", "Stator/Base thickness", "Stator/Tooth height",
        "Stator/Slot width", "Materials/Stator metal/Young modulus",
        "Materials/Piezoceramic/Density", "Wave/Amplitude", "Loading/Preload", "Time/Time step"})
    for (const std::string number : {"0", "-1e-3"})
      expect_refused_override(entry + " = " + number, {entry, number, "a number above 0"});
  EXPECT_NO_THROW(with({"Stator/Piezoceramic thickness = 0"}));
  expect_refused_override("Stator/Piezoceramic thickness = -1e-3", {"a number from 0"});
  for (const std::string ratio : {"0.5", "0.6", "-1", "-2"})
    expect_refused_override("Materials/Stator metal/Poisson ratio = " + ratio,
                            {"Materials/Stator metal/Poisson ratio", ratio,
                             "above -1 and below 0.5", "incompressible"});
  EXPECT_NO_THROW(with({"Materials/Stator metal/Poisson ratio = 0.499"}));
  EXPECT_NO_THROW(with({"Materials/Stator metal/Poisson ratio = -0.9"}));
  for (const std::string target : {"0", "9e-9", "0.11"})
    expect_refused_override("Accuracy/Target = " + target,
                            {"Accuracy/Target", target, "from 1e-8 to 0.1"});
  expect_refused_override("Accuracy/Polynomial degree = 9", {"from 2 to 8"});
  expect_refused_override("Accuracy/Refinement = 7", {"from 0 to 6"});
  expect_refused_override("Output/Frames per period = 1", {"from 2 to 360"});
  for (const std::string places : {"0.0342", "0:", "0:34:1", "-1:0.0342", "0:0", "0:0.034 1:0.034"})
    expect_refused_override("Output/History points = " + places,
                            {"Output/History points", "outer edge", "TOOTH:RADIUS"});
  for (const std::string list : {"", "losses", "speed, speed", "speed:", "speed:2", "all, speed",
                                 "speed torque", "friction loss:0.1:0.2"})
    expect_refused_override(
        "Accuracy/Quantities = " + list,
        {"Accuracy/Quantities", "all, or some of speed, torque", "friction loss:0.1"});
  expect_refused_override("Modes/Number of modes = 0", {"Modes/Number of modes", "from 1"});
  expect_refused_override("Modes/Frequency target = -1", {"Modes/Frequency target", "from 0"});
}

TEST(WrongInput, NumbersWithUnits)
{
  const std::string unit = "without the unit";
  expect_refused_override("Modes/Frequency target = 31kHz", {"31kHz", "in SI", "in Hz", unit});
  expect_refused_override("Wave/Amplitude = 2 um", {"Wave/Amplitude", "2 um", "in m", unit});
  expect_refused_override("Wave/Amplitude = 2 \u00b5m", {"Wave/Amplitude", "in m", unit});
  expect_refused_override("Materials/Piezoceramic/Density = 7.6e3 kg/m^3", {"in kg/m^3", unit});
  expect_refused_override("Friction/Static coefficient = 48 %", {"a plain number", unit});
  expect_refused_override("Loading/Values = 50 mN m", {"N m for torque and rad/s for speed", unit});
  expect_refused_override("Loading/Values = 0, 0.05 N m", {"N m for torque", unit});
  expect_refused_override("Wave/Frequency = 30 kHz", {"in Hz", unit});
  expect_refused_override("Stator/Slot width = 0,0006", {"0,0006", "decimal point"});
}

TEST(WrongInput, NumbersThatAreNotFinite)
{
  for (const std::string number : {"nan", "inf", "-inf", "1e999"})
  {
    expect_refused_override("Stator/Slot width = " + number,
                            {"Stator/Slot width", number, "not a finite number"});
    expect_refused_override("Rotor/Ring lower face = " + number,
                            {"Rotor/Ring lower face", number, "not a finite number"});
  }
}

TEST(WrongInput, EmptyValues)
{
  expect_refused_text("subsection Wave\n  set Amplitude =   # later\nend\n",
                      {"my.prm:2: Wave/Amplitude", "is empty", "a number above 0"});
  for (const std::string entry :
       {"Motor/Name", "Motor/Number of teeth", "Modes/Nodal diameters", "Modes/Body",
        "Stator/Mesh file", "Output/Directory", "Output/VTU", "Loading/Values", "Wave/Frequency"})
    expect_refused_override(entry + " =", {entry, "is empty", "allowed: "});
}

TEST(WrongInput, BrokenSyntax)
{
  expect_refused_text("subsection Motor\n  set Name = a\n",
                      {"my.prm:1: ", "\"Motor\"", "never closed", "end"});
  expect_refused_text("subsection Motor\nend\nend\n", {"my.prm:3: ", "end", "subsection"});
  expect_refused_text("subsection Motor\n  Name = a\nend\n",
                      {"my.prm:2: ", "\"Name = a\"", "set Entry = value"});
  expect_refused_text("subsection Motor\n  set Name\nend\n", {"my.prm:2: ", "set Entry = value"});
  expect_refused_text("subsection Motor\n  set = 7\nend\n", {"my.prm:2: ", "set Entry = value"});
  expect_refused_text("subsection\nend\n", {"my.prm:1: ", "without a name"});
  expect_refused_text("subsection Motor\nend Motor\n", {"my.prm:2: ", "\"end Motor\""});
  expect_refused_text("include base.prm\n", {"my.prm:1: ", "include", "set Base file = PATH"});
  expect_refused_text(std::string("\x7f"
                                  "ELF\x02\x01\x00\x1b[31m",
                                  12),
                      {"my.prm:1: ", "ELF"});
  expect_refused_text(std::string(5000, 'x'), {"my.prm:1: ", "..."});
}

TEST(WrongInput, BrokenOverrides)
{
  expect_refused_override("Wave/Amplitude", {"--set \"Wave/Amplitude\"", "equals sign"});
  expect_refused_override("", {"--set", "equals sign"});
  expect_refused_override("= 5", {"--set", "no entry"});
  expect_refused_override("Wave/ = 5", {"--set", "no entry"});
  expect_refused_override("Wave = 5", {"--set", "unknown entry \"Wave\""});
  expect_refused_override("Motor/Name = a\nb", {"--set", "Motor/Name", "one line"});
  expect_refused_override("Motor/Name = a # b", {"--set", "Motor/Name", "without #"});
}

TEST(WrongInput, FilesThatCannotBeRead)
{
  const auto message = [](const std::string &file)
  { return message_of([&] { read_parameters(file); }); };
  expect_message(message("no/such.prm"), {"no/such.prm", "no such parameter file"});
  const std::string folder = std::filesystem::temp_directory_path().string();
  expect_message(message(folder), {folder, "is a folder"});
}

TEST(WrongInput, WavesAndNodalDiametersAgainstTeeth)
{
  expect_clash({"Motor/Number of teeth = 12"},
               {"Motor/Number of waves = 7", "Motor/Number of teeth = 12", "N - n"});
  expect_clash({"Motor/Number of teeth = 14"}, {"Motor/Number of waves = 7", "cannot travel"});
  EXPECT_NO_THROW(check_for_stator(with({"Motor/Number of teeth = 15"})));
  expect_clash({"Modes/Nodal diameters = 3, 40-46"},
               {"Modes/Nodal diameters = 46", "Motor/Number of teeth = 90", "N - n", "0 to 45"});
  EXPECT_NO_THROW(check_for_stator(with({"Modes/Nodal diameters = 45"})));
  EXPECT_NO_THROW(check_for_stator(with({"Modes/Nodal diameters = all"})));
}

TEST(WrongInput, CrossSectionsThatCross)
{
  expect_clash({"Stator/Base inner radius = 0.037"},
               {"Stator/Base inner radius = 0.037 m", "Stator/Base outer radius = 0.036 m"});
  expect_clash({"Stator/Base inner radius = 0.036"}, {"Stator/Base inner radius", "no width"});
  expect_clash({"Stator/Tip inner radius = 0.035"},
               {"Stator/Tip inner radius = 0.035 m", "Stator/Tip outer radius = 0.0342 m"});
  expect_clash({"Stator/Tip inner radius = 0.0341999"}, {"Stator/Tip inner radius", "do not meet"});
  // A tooth that is wider at its tip is allowed.
  EXPECT_NO_THROW(check_for_stator(with({"Stator/Tip outer radius = 0.040"})));
}

TEST(WrongInput, SlotsWiderThanThePitch)
{
  // Half a pitch at r = 30 mm, at right angles to the slot wall: 30 mm * sin(2 deg) = 1.046985 mm;
  // 95 % of the pitch is then 1.989271 mm.
  expect_clash({"Stator/Slot width = 0.0021"},
               {"Stator/Slot width = 0.0021 m", "Motor/Number of teeth = 90", "0.00198927"});
  expect_clash({"Stator/Slot width = 0.00198928"}, {"Stator/Slot width"});
  EXPECT_NO_THROW(check_for_stator(with({"Stator/Slot width = 0.00198926"})));

  // With the inner side slanted inwards to r = 20 mm the tooth tops have the smallest pitch,
  // 95 % of it is 1.326180 mm.
  const std::string slanted = "Stator/Tip inner radius = 0.020";
  expect_clash({slanted, "Stator/Slot width = 0.00132619"}, {"Stator/Slot width", "0.00132618"});
  EXPECT_NO_THROW(check_for_stator(with({slanted, "Stator/Slot width = 0.00132617"})));

  // Slanted outwards, from 20 mm at z = 0 to 30 mm at z = 6.37 mm, the roots at z = 4.37 mm have
  // it: r = 26.860283 mm, 95 % of the pitch is 1.781076 mm.
  const std::string outwards = "Stator/Base inner radius = 0.020";
  expect_clash({outwards, "Stator/Slot width = 0.00178109"}, {"Stator/Slot width"});
  EXPECT_NO_THROW(check_for_stator(with({outwards, "Stator/Slot width = 0.00178106"})));
}

TEST(WrongInput, AmplitudesThatAreNotSmall)
{
  expect_clash({"Wave/Amplitude = 2e-4"},
               {"Wave/Amplitude = 0.0002 m", "Stator/Base thickness = 0.00437 m", "2e-6"});
}

TEST(WrongInput, WhatAMeshFileCannotHave)
{
  const std::string mesh = "Stator/Mesh file = any.msh";
  expect_clash(
      {mesh, "Stator/Piezoceramic element = shell"},
      {"Stator/Piezoceramic element = shell", "Stator/Mesh file", "any.msh", "allowed: solid"});
}

TEST(WrongInput, ThinPartsThatAreThick)
{
  expect_clash({"Modes/Body = rotor", "Rotor/Flange thickness = 2e-3"},
               {"Rotor/Flange thickness = 0.002 m", "Rotor/Flange element", "30 %", "solid"});
  expect_clash({"Stator/Piezoceramic element = shell", "Stator/Piezoceramic thickness = 3e-3"},
               {"Stator/Piezoceramic thickness = 0.003 m", "Stator/Piezoceramic element", "30 %"});
  expect_clash({"Modes/Body = rotor", "Rotor/Shell thickness = 5e-4"},
               {"Rotor/Shell thickness = 0.0005 m", "section file", "Rotor/Flange thickness"});
}

TEST(WrongInput, RotorsWithoutRoom)
{
  expect_clash({"Modes/Body = rotor", "Rotor/Lip outer radius = 0.0363"},
               {"Rotor/Lip outer radius", "Rotor/Ring inner radius", "Flange thickness"});
  expect_clash({"Modes/Body = rotor", "Rotor/Radial bar height = 0.003"},
               {"Rotor/Ring upper face - Radial bar height", "Flange thickness"});
}

TEST(WrongInput, MeshFiles)
{
  expect_clash({"Stator/Mesh file = no/such.msh"},
               {"Stator/Mesh file", "no/such.msh", "does not exist"});
  expect_clash({"Stator/Mesh file = " + std::filesystem::temp_directory_path().string()},
               {"Stator/Mesh file", "is a folder"});
}

TEST(WrongInput, ClashesWrittenInTheFile)
{
  std::string text       = complete_text();
  const std::string line = "set Slot width";
  const auto begin       = text.find(line);
  text.replace(begin, text.find('\n', begin) - begin, line + " = 0.003");
  const Parameters parameters = read_parameters_from_text(text, "my.prm");
  expect_message(message_of([&] { check_for_stator(parameters); }),
                 {"Stator/Slot width = 0.003 m", "Motor/Number of teeth = 90"});
}
