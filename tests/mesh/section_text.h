// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/gmsh_text.h"
#include "output/scratch.h"

#include <ringmotor/mesh/read_section.h>

#include <map>
#include <string>
#include <vector>

namespace ringmotor::tests
{
  /** The text of a section as Gmsh writes it. */
  struct SectionText
  {
    struct Element
    {
      int kind;                ///< Gmsh's
      std::string name;        ///< physical; empty: none
      std::vector<int> points; ///< from 0
    };
    std::vector<dealii::Point<2>> points;
    std::vector<Element> elements;

    SectionText() = default;

    /** @param names of its parts and edges, by dimension and id */
    SectionText(const Section &section, const std::map<std::pair<int, int>, std::string> &names)
        : points(section.points)
    {
      for (const Section::Cell &cell : section.cells)
        elements.push_back(
            {3, names.at({2, cell.part}), {cell.corners.begin(), cell.corners.end()}});
      for (const auto &[edge, name] : section.names)
        if (const auto known = names.find({1, name}); known != names.end())
          elements.push_back(
              {1, known->second, {static_cast<int>(edge.first), static_cast<int>(edge.second)}});
      const int first = points.size();
      points.insert(points.end(), section.shell.points.begin(), section.shell.points.end());
      for (int i = first; i + 1 < static_cast<int>(points.size()); ++i)
      {
        elements.push_back({1, "shell", {i, i + 1}});
        if (i - first < static_cast<int>(section.shell.n_in_contact))
          elements.push_back({1, "contact", {i, i + 1}});
      }
    }

    /** Writes it to a file of the folder and returns its path. */
    std::string write(const Scratch &scratch, const std::string &name = "section.msh") const
    {
      std::vector<dealii::Point<3>> nodes;
      for (const dealii::Point<2> &x : points)
        nodes.emplace_back(x[0], x[1], 0.);
      std::vector<GmshTextElement> of_file;
      for (const Element &element : elements)
        of_file.push_back(
            {element.kind, element.name, {element.points.begin(), element.points.end()}});
      return write_gmsh(scratch.path(name), nodes, of_file);
    }
  };

  /** Names of a stator's parts and edges in a file. */
  inline std::map<std::pair<int, int>, std::string> names_of_stator()
  {
    return {{{2, 1}, "base"},     {{2, 2}, "tooth"},    {{2, 3}, "piezoceramic"},
            {{1, 15}, "contact"}, {{1, 21}, "clamped"}, {{1, 24}, "felt"}};
  }

  /** The same of a rotor. */
  inline std::map<std::pair<int, int>, std::string> names_of_rotor()
  {
    return {{{2, 4}, "rotor"},    {{2, 6}, "lining"},  {{2, 7}, "adhesive"}, {{1, 16}, "contact"},
            {{1, 17}, "pressed"}, {{1, 18}, "driven"}, {{1, 22}, "bars"}};
  }

  /** A clamped web, a ring of three blocks above it with a tooth on top, and a ceramic ring below:
   *
   *       8--9       tooth
   *       6--7       ring
   *    2--4--5       web, ring
   *    0--1--3
   *       10-11      ceramic
   */
  inline SectionText disc()
  {
    SectionText text;
    text.points   = {{10e-3, 0.},   {20e-3, 0.},   {10e-3, 1e-3},  {30e-3, 0.},
                     {20e-3, 1e-3}, {30e-3, 1e-3}, {20e-3, 3e-3},  {30e-3, 3e-3},
                     {20e-3, 5e-3}, {30e-3, 5e-3}, {20e-3, -5e-4}, {30e-3, -5e-4}};
    text.elements = {
        {3, "base", {0, 1, 4, 2}},  {3, "base", {1, 3, 5, 4}},           {3, "base", {4, 5, 7, 6}},
        {3, "tooth", {6, 7, 9, 8}}, {3, "piezoceramic", {10, 11, 3, 1}}, {1, "clamped", {0, 2}},
        {1, "contact", {8, 9}}};
    return text;
  }

  /** Three blocks of a base with three of a tooth on them. */
  inline SectionText three_columns()
  {
    SectionText text;
    for (const double z : {0., 2e-3, 4e-3})
      for (const double r : {10e-3, 15e-3, 20e-3, 25e-3})
        text.points.emplace_back(r, z);
    for (const int j : {0, 1})
      for (const int i : {0, 1, 2})
        text.elements.push_back({3,
                                 j == 0 ? "base" : "tooth",
                                 {4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4}});
    for (const int i : {8, 9, 10})
      text.elements.push_back({1, "contact", {i, i + 1}});
    return text;
  }

  /** A hub, a web and a ring with a lining below:
   *
   *    4--5--6--7
   *    0--1--2--3
   *          8--9
   *
   * @param hub m, the inner radius */
  inline SectionText ring_on_web(const double hub)
  {
    SectionText text;
    for (const double z : {0., 2e-3})
      for (const double r : {hub, 10e-3, 20e-3, 24e-3})
        text.points.emplace_back(r, z);
    text.points.emplace_back(20e-3, -1e-3);
    text.points.emplace_back(24e-3, -1e-3);
    text.elements = {{3, "rotor", {0, 1, 5, 4}}, {3, "rotor", {1, 2, 6, 5}},
                     {3, "rotor", {2, 3, 7, 6}}, {3, "lining", {8, 9, 3, 2}},
                     {1, "contact", {8, 9}},     {1, "pressed", {4, 5}},
                     {1, "driven", {0, 4}}};
    return text;
  }

  inline Section read(const SectionText &text, const BodyOf body = BodyOf::stator)
  {
    const Scratch scratch;
    return read_section(text.write(scratch), body);
  }

} // namespace ringmotor::tests
