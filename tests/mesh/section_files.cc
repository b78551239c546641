// SPDX-License-Identifier: LGPL-2.1-or-later

// Every mistake in the file of a cross-section is refused in one line that says where it is and
// what to do.

#include "mesh/section_text.h"

#include <ringmotor/parameters/errors.h>

#include <gtest/gtest.h>

#include <functional>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  void expect_refusal(const SectionText &text, const std::vector<std::string> &words,
                      const BodyOf body = BodyOf::stator)
  {
    const std::string message = message_of<UserError>([&]() { read(text, body); });
    EXPECT_EQ(message.find(body == BodyOf::stator ? "Stator/Section file = \""
                                                  : "Rotor/Section file = \""),
              0u)
        << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << message; // what to do
    for (const std::string &word : words)
      EXPECT_NE(message.find(word), std::string::npos) << '"' << word << "\" not in: " << message;
  }
} // namespace

TEST(SectionFile, RefusesBodiesThatAreNotOne)
{
  EXPECT_EQ(read(three_columns()).cells.size(), 6u);
  SectionText crack = three_columns(); // between the rows, open up to the last column
  crack.points.insert(crack.points.end(), {crack.points[4], crack.points[5]});
  crack.elements[3].points = {12, 13, 9, 8};
  crack.elements[4].points = {13, 6, 10, 9};
  expect_refusal(crack, {"touch without sharing their points", "r = 10 mm, z = 2 mm"});
  SectionText gap = crack; // half a micrometre wide: closer than a file's rounding is none
  gap.points[13][1] += 5e-9;
  expect_refusal(gap, {"touch without sharing their points"});
  SectionText fold = three_columns(); // back over its neighbour
  fold.points.emplace_back(12e-3, 0.);
  fold.points.emplace_back(12e-3, 2e-3);
  fold.elements[2].points = {2, 12, 13, 6};
  expect_refusal(fold, {"lie on one another", "r = 20 mm"});
  SectionText one = three_columns();
  one.elements.push_back(one.elements[0]);
  expect_refusal(one, {"lie on one another"});
  SectionText small = three_columns();
  for (Point<2> &x : small.points)
    x *= 1e-3;
  expect_refusal(small, {"outer radius is 2.5e-05 m"});
}

TEST(SectionFile, RefusesTeethWithoutAFootOrATop)
{
  SectionText on_ceramic      = three_columns();
  on_ceramic.elements[1].name = "piezoceramic";
  expect_refusal(on_ceramic, {"a tooth stands on the piezoceramic"});
  SectionText two_tops = three_columns();
  two_tops.elements.erase(two_tops.elements.begin() + 7);
  expect_refusal(two_tops, {"'contact' is in pieces"});
  SectionText step = three_columns();
  step.elements.pop_back();
  step.points[11][1] = 5e-3;
  expect_refusal(step, {"reaches z = 4 mm, below the highest point, z = 5 mm"});
  SectionText two_feet = three_columns();
  two_feet.elements.erase(two_feet.elements.begin() + 1);
  expect_refusal(two_feet, {"the foot of the tooth is in pieces"});
}

TEST(SectionFile, RefusesMistakes)
{
  using Change      = std::function<void(SectionText &)>;
  const auto refuse = [](const Change &change, const std::vector<std::string> &words)
  {
    SectionText text = disc();
    change(text);
    expect_refusal(text, words);
  };
  const auto scale = [](const double factor)
  {
    return [factor](SectionText &text)
    {
      for (Point<2> &x : text.points)
        x *= factor;
    };
  };
  refuse(
      [](SectionText &text) {
        text.elements[3] = {2, "tooth", {6, 7, 9}};
      },
      {"triangles", "Recombine Surface"});
  refuse(
      [](SectionText &text) {
        text.elements[3] = {16, "tooth", {6, 7, 9, 8, 6, 7, 9, 8}};
      },
      {"second order"});
  refuse([](SectionText &text)
         { text.elements.erase(text.elements.begin(), text.elements.begin() + 5); },
         {"no quadrilaterals"});
  refuse([](SectionText &text) { text.elements[0].name = "web"; },
         {"a surface has the name 'web'", "r = 15 mm", "allowed: base, tooth or piezoceramic"});
  refuse([](SectionText &text) { text.elements[1].name = ""; },
         {"a surface has no name", "Physical Surface"});
  refuse([](SectionText &text) { text.elements[5].name = "clamp"; },
         {"a curve has the name 'clamp'", "allowed: contact, clamped or felt"});
  refuse(scale(1e3), {"outer radius is 30 m", "Mesh.ScalingFactor = 0.001"});
  refuse([](SectionText &text) { text.points[0][0] = text.points[2][0] = 0.; },
         {"reaches r = 0 mm", "leave a bore"});
  refuse([](SectionText &text) { text.points[0][0] = text.points[2][0] = -10e-3; },
         {"reaches r = -10 mm", "one side of the axis"});
  refuse([](SectionText &text)
         { std::swap(text.elements[2].points[0], text.elements[2].points[1]); },
         {"not convex", "z = 2 mm"});
  refuse([](SectionText &text) { text.points[4] = {29e-3, 2.5e-3}; }, {"not convex"});
  refuse(
      [](SectionText &text)
      {
        text.points.insert(text.points.end(), {{20e-3, 0.}, {20e-3, 1e-3}});
        text.elements[0].points = {0, 12, 13, 2};
      },
      {"it is in pieces", "share their edges"});
  refuse([](SectionText &text) { text.elements.push_back(text.elements[1]); },
         {"lie on one another"});
  refuse(
      [](SectionText &text) {
        text.elements[6].points = {4, 5};
      },
      {"'contact', at r = 25 mm, z = 1 mm, lies inside"});
  refuse([](SectionText &text) { text.elements[5].points = {0, 4}; }, {"is not an edge"});
  refuse(
      [](SectionText &text) {
        text.elements.push_back({1, "felt", {0, 2}});
      },
      {"has a second name"});
  refuse(
      [](SectionText &text) {
        text.elements[6].points = {10, 11};
      },
      {"'contact' does not face the rotor"});
  refuse(
      [](SectionText &text) {
        text.elements[6].points = {2, 4};
      },
      {"'contact' lies on the base"});
  refuse(
      [](SectionText &text)
      {
        for (SectionText::Element &element : text.elements)
          if (element.name == "base")
            element.name = "tooth";
      },
      {"it has no base"});
  refuse([](SectionText &text) { text.elements.pop_back(); },
         {"teeth have no curve 'contact'", "Physical Curve"});
  refuse([](SectionText &text) { text.points[9][1] = text.points[8][1] = 3e-3; }, {"not convex"});
  expect_refusal(disc(), {"a surface has the name 'base'", "allowed: rotor, lining or adhesive"},
                 BodyOf::rotor);
}
