// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "output/scratch.h"

#include <ringmotor/mesh/read_section.h>

#include <fstream>
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
      const auto dimension = [](const Element &element)
      { return element.kind == 1 || element.kind == 8 ? 1 : 2; };
      std::map<std::pair<int, std::string>, int> ids;
      for (const Element &element : elements)
        if (!element.name.empty())
          ids.emplace(std::make_pair(dimension(element), element.name), ids.size() + 1);
      std::ofstream file(scratch.path(name));
      file.precision(17);
      file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << ids.size() << "\n";
      for (const auto &[key, id] : ids)
        file << key.first << ' ' << id << " \"" << key.second << "\"\n";
      file << "$EndPhysicalNames\n$Nodes\n" << points.size() << "\n";
      for (unsigned int i = 0; i < points.size(); ++i)
        file << i + 1 << ' ' << points[i][0] << ' ' << points[i][1] << " 0\n";
      file << "$EndNodes\n$Elements\n" << elements.size() << "\n";
      for (unsigned int i = 0; i < elements.size(); ++i)
      {
        const Element &element = elements[i];
        const int id = element.name.empty() ? 0 : ids.at({dimension(element), element.name});
        file << i + 1 << ' ' << element.kind << " 2 " << id << ' ' << i + 1;
        for (const int point : element.points)
          file << ' ' << point + 1;
        file << "\n";
      }
      file << "$EndElements\n";
      return scratch.path(name);
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

  inline Section read(const SectionText &text, const BodyOf body = BodyOf::stator)
  {
    const Scratch scratch;
    return read_section(text.write(scratch), body);
  }

} // namespace ringmotor::tests
