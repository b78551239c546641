// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/gmsh_text.h"
#include "output/scratch.h"

#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/section.h>
#include <ringmotor/mesh/sector_mesh.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace ringmotor::tests
{
  /** The text of a mesh of a sector as Gmsh writes it, with named groups. */
  struct NamedSector
  {
    struct Element
    {
      int dimension;               ///< 3: hexahedron, 2: quadrilateral
      std::string name;            ///< physical; empty: none
      std::vector<unsigned> nodes; ///< from 0
    };
    std::vector<dealii::Point<3>> nodes;
    std::vector<Element> elements;

    NamedSector() = default;

    /** The half of a sector that has been meshed, of the stator or the rotor. */
    explicit NamedSector(const SectorMesh &mesh) : nodes(mesh.triangulation->get_vertices())
    {
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
      {
        elements.push_back({3, name_of_part(cell->material_id()), {}});
        for (unsigned int i = 0; i < 8; ++i)
          elements.back().nodes.push_back(
              cell->vertex_index(dealii::GeometryInfo<3>::ucd_to_deal[i]));
      }
      for (const auto &face : mesh.triangulation->active_face_iterators())
        if (const auto id = face->boundary_id(); face->at_boundary() && id != ids::free)
          elements.push_back({2,
                              id == ids::mirror ? "mirror"
                              : id == ids::cut  ? "cut"
                                                : name_of_edge(id),
                              {face->vertex_index(0), face->vertex_index(1), face->vertex_index(3),
                               face->vertex_index(2)}});
    }

    void rename(const std::string &from, const std::string &to)
    {
      for (Element &element : elements)
        if (element.name == from)
          element.name = to;
    }

    /** Writes it to a file of the folder, lengths multiplied by @p scale, and returns its path. */
    std::string write(const Scratch &scratch, const std::string &file,
                      const double scale = 1.) const
    {
      std::vector<dealii::Point<3>> scaled;
      for (const dealii::Point<3> &x : nodes)
        scaled.push_back(scale * x);
      std::vector<GmshTextElement> of_file;
      for (const Element &element : elements)
        of_file.push_back({element.dimension == 3 ? 5 : 3, element.name, element.nodes});
      return write_gmsh(scratch.path(file), scaled, of_file);
    }
  };

  /** Half a sector of cells between lines of r, theta and z. */
  struct GridSector : NamedSector
  {
    using Place = std::array<int, 3>; ///< of a cell, from 0
    using Parts = std::function<std::string(const Place &)>;
    /** The name of an outer face of a cell, on its lower or upper side along r or z. */
    using Faces = std::function<std::string(const Place &, int direction, bool is_upper)>;

    /** @param lines m and rad @param part empty: no cell there */
    GridSector(const std::array<std::vector<double>, 3> &lines, const Parts &part,
               const Faces &face)
        : lines(lines)
    {
      for (const double z : lines[2])
        for (const double theta : lines[1])
          for (const double r : lines[0])
            nodes.push_back(cartesian(dealii::Point<3>(r, theta, z)));
      const auto part_at = [&](const Place &at)
      {
        for (unsigned int d = 0; d < 3; ++d)
          if (at[d] < 0 || at[d] + 1 >= static_cast<int>(lines[d].size()))
            return std::string();
        return part(at);
      };
      for (int k = 0; k + 1 < static_cast<int>(lines[2].size()); ++k)
        for (int j = 0; j + 1 < static_cast<int>(lines[1].size()); ++j)
          for (int i = 0; i + 1 < static_cast<int>(lines[0].size()); ++i)
            if (const Place at{{i, j, k}}; !part_at(at).empty())
            {
              elements.push_back({3, part_at(at), {}});
              for (const int up : {0, 1})
                for (const auto &[a, b] : {std::make_pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
                  elements.back().nodes.push_back(node({{i + a, j + b, k + up}}));
              for (const int direction : {0, 1, 2})
                for (const bool is_upper : {false, true})
                {
                  Place next = at;
                  next[direction] += is_upper ? 1 : -1;
                  if (part_at(next).empty())
                    add_face(at, direction, is_upper, face);
                }
            }
    }

  private:
    unsigned int node(const Place &at) const
    {
      return at[0] + lines[0].size() * (at[1] + lines[1].size() * at[2]);
    }

    void add_face(const Place &at, const int direction, const bool is_upper, const Faces &face)
    {
      std::string name;
      if (direction == 1 && !is_upper && at[1] == 0)
        name = "mirror";
      else if (direction == 1 && is_upper && at[1] + 2 == static_cast<int>(lines[1].size()))
        name = "cut";
      else if (direction != 1)
        name = face(at, direction, is_upper);
      if (name.empty())
        return;
      elements.push_back({2, name, {}});
      const int a = (direction + 1) % 3, b = (direction + 2) % 3;
      for (const auto &[on_a, on_b] : {std::make_pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
      {
        Place corner = at;
        corner[direction] += is_upper ? 1 : 0;
        corner[a] += on_a;
        corner[b] += on_b;
        elements.back().nodes.push_back(node(corner));
      }
    }

    const std::array<std::vector<double>, 3> lines;
  };
} // namespace ringmotor::tests
