// SPDX-License-Identifier: LGPL-2.1-or-later

// Every mistake in the file of a cross-section is refused in one line that says where it is and
// what to do.

#include "mesh/section_text.h"

#include <ringmotor/parameters/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  /** Middles of the sides of quadrilaterals, points that these share. */
  class Middles
  {
  public:
    Middles(SectionText &text, const std::function<Point<2>(const Point<2> &)> &bend)
        : text(text), bend(bend)
    {
    }

    int between(const int a, const int b)
    {
      const auto [entry, is_new] =
          known.emplace(std::minmax(a, b), static_cast<int>(text.points.size()));
      if (is_new)
        text.points.push_back(bend(Point<2>(0.5 * (text.points[a] + text.points[b]))));
      return entry->second;
    }

  private:
    SectionText &text;
    const std::function<Point<2>(const Point<2> &)> bend;
    std::map<std::pair<int, int>, int> known;
  };

  /** The same section with elements of second order (8 or 9 nodes), whose middles @p bend moves,
   * and with the parts of these elements. */
  struct SecondOrder
  {
    SectionText whole, parts;

    SecondOrder(const SectionText &first, const int n_nodes,
                const std::function<Point<2>(const Point<2> &)> &bend)
    {
      whole.points = first.points;
      Middles middles(whole, bend);
      for (const SectionText::Element &element : first.elements)
      {
        const std::vector<int> &c = element.points;
        std::vector<int> all      = c;
        for (std::size_t i = 0; i < (c.size() == 2 ? 1 : 4); ++i)
          all.push_back(middles.between(c[i], c[(i + 1) % c.size()]));
        if (c.size() == 2)
        {
          parts.elements.push_back({1, element.name, {all[0], all[2]}});
          parts.elements.push_back({1, element.name, {all[2], all[1]}});
          whole.elements.push_back({8, element.name, all});
          continue;
        }
        Point<2> centre;
        for (unsigned int i = 0; i < 4; ++i)
          centre += 0.5 * whole.points[all[4 + i]] - 0.25 * whole.points[all[i]];
        whole.points.push_back(centre);
        all.push_back(whole.points.size() - 1);
        for (unsigned int i = 0; i < 4; ++i)
          parts.elements.push_back(
              {3, element.name, {all[i], all[4 + i], all[8], all[4 + (i + 3) % 4]}});
        if (n_nodes == 8)
          all.pop_back();
        whole.elements.push_back({n_nodes == 8 ? 16 : 10, element.name, all});
      }
      parts.points = whole.points;
    }
  };

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

TEST(SectionFile, SplitsElementsOfSecondOrder)
{
  const auto straight = [](const Point<2> &x) { return x; };
  const auto bent     = [](const Point<2> &x) // the lower face only
  { return x[1] < 1e-9 ? Point<2>(x[0], x[1] - 0.4e-3) : x; };
  for (const int n_nodes : {8, 9})
    for (const auto &bend : {std::function<Point<2>(const Point<2> &)>(straight), {bent}})
    {
      SectionText drawn = three_columns();
      drawn.elements.push_back({1, "felt", {0, 1}});
      const SecondOrder order(drawn, n_nodes, bend);
      const Section whole = read(order.whole), parts = read(order.parts);
      ASSERT_EQ(whole.cells.size(), 24u);
      ASSERT_EQ(parts.cells.size(), 24u);
      ASSERT_EQ(whole.points.size(), parts.points.size());
      for (unsigned int i = 0; i < whole.points.size(); ++i)
        EXPECT_LT(whole.points[i].distance(parts.points[i]), 1e-17); // 17 digits in the file
      for (unsigned int i = 0; i < whole.cells.size(); ++i)
      {
        EXPECT_EQ(whole.cells[i].corners, parts.cells[i].corners);
        EXPECT_EQ(whole.cells[i].part, parts.cells[i].part);
      }
      EXPECT_EQ(whole.names, parts.names);
      EXPECT_EQ(whole.names.size(), 8u); // three edges in contact, one on the felt, in two parts
    }
}

TEST(SectionFile, KeepsTheMiddlesOfCurvedEdges)
{
  // The lower face of the first cell, r from 10 to 15 mm, z from 0 to 2 mm, sags by 0.4 mm: so does
  // its middle, and the centre of the cell of 8 nodes by half of that.
  const SecondOrder order(three_columns(), 8,
                          [](const Point<2> &x)
                          { return x[1] < 1e-9 ? Point<2>(x[0], x[1] - 0.4e-3) : x; });
  const Section section = read(order.whole);
  for (const Point<2> &expected : {Point<2>(12.5e-3, -0.4e-3), Point<2>(12.5e-3, 0.8e-3)})
    EXPECT_TRUE(std::any_of(section.points.begin(), section.points.end(),
                            [&](const Point<2> &x) { return x.distance(expected) < 1e-12; }))
        << expected;
  double area = 0.; // of the base, to the polygons through the nodes
  for (const Section::Cell &cell : section.cells)
    if (cell.part == 1)
    {
      const auto &c                = cell.corners;
      const dealii::Tensor<1, 2> a = section.points[c[2]] - section.points[c[0]],
                                 b = section.points[c[3]] - section.points[c[1]];
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
  EXPECT_NEAR(area, 15e-3 * 2e-3 + 3. * 0.5 * 5e-3 * 0.4e-3, 1e-15);
}

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
      [](SectionText &text)
      {
        text.elements[3] = {9, "tooth", {6, 7, 9, 8, 6, 7}}; // a triangle of second order
      },
      {"Gmsh's kind 9", "first or second order"});
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
