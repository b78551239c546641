// SPDX-License-Identifier: LGPL-2.1-or-later

// Sections that the program stator reads but that cannot be in contact are refused in one line that
// says what was found and what to do.

#include "mesh/section_text.h"

#include <ringmotor/mesh/check_contact.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>

#include <gtest/gtest.h>

#include <functional>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  /** A ring beside the stator with a short arm, and a shell inwards from there:
   *
   *                6--7
   *    8--9--- 10= 4--5     the arm between 10 = (0, 1, 2, 3) and 4
   *                2--3
   */
  SectionText shell_rotor()
  {
    SectionText text;
    text.points   = {{27.75e-3, -0.25e-3}, {27.75e-3, 0.25e-3}, {28e-3, -0.25e-3}, {28e-3, 0.25e-3},
                     {28e-3, -1e-3},       {32e-3, -1e-3},      {32e-3, -0.25e-3}, {32e-3, 0.25e-3},
                     {28e-3, 3e-3},        {32e-3, 3e-3},       {22e-3, 0.},       {24e-3, 0.},
                     {27.75e-3, 0.},       {26e-3, 0.}};
    text.elements = {{3, "rotor", {0, 2, 3, 1}}, {3, "rotor", {4, 5, 6, 2}},
                     {3, "rotor", {2, 6, 7, 3}}, {3, "rotor", {3, 7, 9, 8}},
                     {1, "pressed", {8, 9}},     {1, "driven", {3, 8}},
                     {1, "contact", {11, 10}},   {1, "shell", {10, 11}},
                     {1, "shell", {13, 11}},     {1, "shell", {12, 13}}};
    return text;
  }

  struct Sections
  {
    SectionText stator = three_columns(), rotor = ring_on_web(5e-3);
    Parameters parameters;
  };

  std::string message_with(const std::function<void(Sections &)> &change)
  {
    const Scratch scratch;
    Sections of;
    of.parameters.rotor.radial_bar_stiffness = 0.;
    of.parameters.motor.n_teeth              = 60;
    change(of);
    of.parameters.stator.section_file = of.stator.write(scratch, "stator.msh");
    of.parameters.rotor.section_file  = of.rotor.write(scratch, "rotor.msh");
    return message_of<UserError>([&]() { check_bodies_in_contact(of.parameters); });
  }

  void expect_refusal(const std::function<void(Sections &)> &change,
                      const std::vector<std::string> &words)
  {
    const std::string message = message_with(change);
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << message; // what to do
    for (const std::string &word : words)
      EXPECT_NE(message.find(word), std::string::npos) << '"' << word << "\" not in: " << message;
  }

  void erase(SectionText &text, const std::string &name)
  {
    for (std::size_t i = 0; i < text.elements.size();)
      if (text.elements[i].name == name)
        text.elements.erase(text.elements.begin() + i);
      else
        ++i;
  }
} // namespace

TEST(ContactSections, AreAccepted)
{
  EXPECT_EQ(message_with([](Sections &) {}), "nothing thrown");
}

TEST(ContactSections, NeedTheEdgesOfContactAndLoads)
{
  for (const auto &[name, what] : {std::make_pair("pressed", "the preload acts"),
                                   {"driven", "the load torque acts"},
                                   {"contact", "the lower face of lip or lining"}})
    expect_refusal([name = name](Sections &of) { erase(of.rotor, name); },
                   {"Rotor/Section file = \"", std::string("it has no curve '") + name, what});
  expect_refusal(
      [](Sections &of)
      {
        erase(of.stator, "contact");
        for (SectionText::Element &element : of.stator.elements)
          element.name = "base";
      },
      {"Stator/Section file = \"", "it has no curve 'contact'", "contact needs teeth"});
  expect_refusal(
      [](Sections &of) {
        of.rotor.elements.push_back({1, "clamped", {3, 7}});
      },
      {"Rotor/Section file = \"", "it has the curve 'clamped'"});
  expect_refusal([](Sections &of) { of.parameters.not_given = {"Materials/Lining/Loss factor"}; },
                 {"Materials/Lining/Loss factor", "Rotor/Section file has the part 'lining'"});
}

TEST(ContactSections, NeedNearlyLevelLinesThatOverlap)
{
  expect_refusal([](Sections &of) { of.rotor.points[9][1] = -1.9e-3; },
                 {"Rotor/Section file = \"", "reaches from z = -1.9 mm to -1 mm",
                  "level, crowned or conical up to a tenth of its width"});
  expect_refusal(
      [](Sections &of)
      {
        for (dealii::Point<2> &x : of.rotor.points)
          x[0] += 10e-3;
      },
      {"the lip misses the teeth", "the curve 'contact' of Rotor/Section file = \"",
       "from r = 30 mm to 34 mm", "the curve 'contact' of Stator/Section file = \"",
       "from r = 10 mm to 25 mm", "at least 10 um"});
  expect_refusal(
      [](Sections &of) {
        of.parameters.output.history_points = {{0., 0.0195}};
      },
      {"Output/History points: radius 0.0195 m", "allowed: 0.02 to 0.024 m"});
  expect_refusal(
      [](Sections &of)
      {
        // The hub reaches below the tops, in the tooth.
        of.rotor.points[0] = {11e-3, -1.5e-3};
        of.rotor.points[1] = {13e-3, -1.5e-3};
        of.rotor.points[4] = {11e-3, 2e-3};
        of.rotor.points[5] = {13e-3, 2e-3};
      },
      {"the rotor cuts into the stator, at r = ", "touch along these lines only"});
}

namespace
{
  /** With the rotor of a shell of 0.5 mm. */
  std::function<void(Sections &)> with_shell(const std::function<void(Sections &)> &change)
  {
    return [change](Sections &of)
    {
      of.rotor                            = shell_rotor();
      of.parameters.rotor.shell_thickness = 0.5e-3;
      change(of);
    };
  }

  /** The same with one more named curve. */
  std::function<void(Sections &)> with_shell_and(const SectionText::Element &curve)
  {
    return with_shell([curve](Sections &of) { of.rotor.elements.push_back(curve); });
  }
} // namespace

TEST(ContactSections, MayHaveAShell)
{
  EXPECT_EQ(message_with(with_shell([](Sections &) {})), "nothing thrown");
  // A point of the surfaces in the middle of the edge that the shell is tied to.
  EXPECT_EQ(message_with(with_shell(
                [](Sections &of)
                {
                  of.rotor.points.insert(of.rotor.points.end(), {{28e-3, 0.}, {32e-3, 0.}});
                  of.rotor.elements[0].points = {0, 2, 14, 12};
                  of.rotor.elements[2].points = {2, 6, 15, 14};
                  of.rotor.elements.push_back({3, "rotor", {12, 14, 3, 1}});
                  of.rotor.elements.push_back({3, "rotor", {14, 15, 7, 3}});
                })),
            "nothing thrown");
  const Section section = read(shell_rotor(), BodyOf::rotor);
  EXPECT_EQ(section.points.size(), 10u); // those of the cells
  ASSERT_EQ(section.shell.points.size(), 3u);
  EXPECT_EQ(section.shell.n_in_contact, 1u);
  EXPECT_NEAR(section.shell.points[0][0], 22e-3, 1e-15);
  EXPECT_NEAR(section.shell.points[1][0], 24e-3, 1e-15);
  EXPECT_NEAR(section.shell.points[2][0], 27.75e-3, 1e-15);
}

TEST(ContactSections, NeedAShellWithAThickness)
{
  expect_refusal(with_shell([](Sections &of) { of.parameters.rotor.shell_thickness = {}; }),
                 {"Rotor/Section file has the curve 'shell'", "Rotor/Shell thickness is none"});
  expect_refusal([](Sections &of) { of.parameters.rotor.shell_thickness = 0.5e-3; },
                 {"Rotor/Shell thickness = 0.0005 m", "no curve 'shell'", "or give none"});
  expect_refusal(with_shell([](Sections &of) { of.parameters.rotor.shell_thickness = 2e-3; }),
                 {"Rotor/Shell thickness = 0.002 m is not thin", "30 % of it"});
  expect_refusal(with_shell([](Sections &of) { of.parameters.rotor.shell_thickness = 0.6e-3; }),
                 {"the curve 'shell' ends at r = 27.75 mm, z = 0 mm",
                  "Rotor/Shell thickness = 0.6 mm", "at right angles"});
}

TEST(ContactSections, NeedAShellThatIsTiedToTheBody)
{
  expect_refusal(
      with_shell([](Sections &of) { of.rotor.points[12][0] = 27.7e-3; }),
      {"the ends r = 22 mm, z = 0 mm and r = 27.7 mm, z = 0 mm", "is tied to the body at neither"});
  expect_refusal(
      with_shell([](Sections &of) { of.rotor.elements.erase(of.rotor.elements.begin() + 8); }),
      {"the curve 'shell' is in pieces"});
  expect_refusal(with_shell_and({1, "shell", {13, 4}}),
                 {"the curve 'shell' is in pieces, or branches"});
  expect_refusal(with_shell_and({1, "shell", {2, 4}}),
                 {"the curve 'shell' is an edge of a surface"});
  expect_refusal(with_shell_and({1, "driven", {0, 1}}), {"has the name 'driven'"});
  expect_refusal(with_shell_and({1, "pressed", {11, 10}}),
                 {"the curve 'shell' has the name 'pressed', too", "besides shell: contact"});
  expect_refusal(with_shell(
                     [](Sections &of) {
                       of.rotor.elements[6].points = {13, 11};
                     }),
                 {"does not begin at its free end"});
  expect_refusal(with_shell([](Sections &of) { of.rotor.points[10][1] = 1e-5; }),
                 {"the curve 'contact' on the shell is not level"});
  expect_refusal(with_shell([](Sections &of) { of.rotor.points[10][0] = 25e-3; }),
                 {"does not lead outwards"});
  expect_refusal(with_shell([](Sections &of) { erase(of.rotor, "contact"); }),
                 {"it has no curve 'contact'"});
  expect_refusal(with_shell_and({1, "contact", {4, 5}}),
                 {"'contact' lies on the shell and on surfaces"});
  // The shell, which is level with the tooth tops where it touches, dips into a tooth outside.
  expect_refusal(with_shell(
                     [](Sections &of)
                     {
                       of.rotor.points[10][0] = 12e-3;
                       of.rotor.points[11][0] = 14e-3;
                       of.rotor.points[13]    = {20e-3, -0.5e-3};
                       of.rotor.points.emplace_back(26e-3, 0.);
                       of.rotor.elements.back().points = {12, 14};
                       of.rotor.elements.push_back({1, "shell", {14, 13}});
                     }),
                 {"the rotor cuts into the stator"});
}

TEST(ContactSections, BoundTheAmplitude)
{
  expect_refusal([](Sections &of) { of.parameters.wave.amplitude = 2e-3; },
                 {"Wave/Amplitude = 0.002 m", "the height of Stator/Section file = 0.004 m"});
}
