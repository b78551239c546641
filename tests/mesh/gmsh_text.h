// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ringmotor::tests
{
  struct GmshTextElement
  {
    int kind;                        ///< Gmsh's
    std::string name;                ///< physical; empty: none
    std::vector<unsigned int> nodes; ///< from 0
  };

  /** Writes a mesh with named groups, as Gmsh does, to a file. @return its path */
  inline std::string write_gmsh(const std::string &path, const std::vector<dealii::Point<3>> &nodes,
                                const std::vector<GmshTextElement> &elements)
  {
    const auto dimension = [](const GmshTextElement &element) {
      return element.kind == 5 ? 3 : element.kind == 1 || element.kind == 8 ? 1 : 2;
    };
    std::map<std::pair<int, std::string>, int> ids;
    for (const GmshTextElement &element : elements)
      if (!element.name.empty())
        ids.emplace(std::make_pair(dimension(element), element.name), ids.size() + 1);
    std::ofstream file(path);
    file.precision(17);
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << ids.size() << "\n";
    for (const auto &[key, id] : ids)
      file << key.first << ' ' << id << " \"" << key.second << "\"\n";
    file << "$EndPhysicalNames\n$Nodes\n" << nodes.size() << "\n";
    for (unsigned int i = 0; i < nodes.size(); ++i)
      file << i + 1 << ' ' << nodes[i] << "\n";
    file << "$EndNodes\n$Elements\n" << elements.size() << "\n";
    for (unsigned int i = 0; i < elements.size(); ++i)
    {
      const GmshTextElement &element = elements[i];
      file << i + 1 << ' ' << element.kind << " 2 "
           << (element.name.empty() ? 0 : ids.at({dimension(element), element.name})) << ' '
           << i + 1;
      for (const unsigned int node : element.nodes)
        file << ' ' << node + 1;
      file << "\n";
    }
    file << "$EndElements\n";
    return path;
  }
} // namespace ringmotor::tests
