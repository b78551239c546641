// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/split_elements.h>

#include <array>
#include <utility>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The centre of a quadrilateral of four corners and four middles: their shape functions are
     * -1/4 and 1/2 there. */
    Point<3> centre_of(const std::vector<unsigned int> &nodes, const std::vector<Point<3>> &places)
    {
      Point<3> centre;
      for (unsigned int i = 0; i < 4; ++i)
        centre += 0.5 * places[nodes[4 + i]] - 0.25 * places[nodes[i]];
      return centre;
    }
  } // namespace

  GmshMesh with_split_elements(GmshMesh mesh)
  {
    std::vector<GmshMesh::Element> elements;
    for (GmshMesh::Element &element : mesh.elements)
    {
      std::vector<unsigned int> &n = element.nodes;
      const auto add = [&](const GmshMesh::Kind kind, const std::vector<unsigned int> &nodes) {
        elements.push_back({kind, element.id, nodes});
      };
      if (element.kind == GmshMesh::quadrilateral_of_8)
      {
        n.push_back(mesh.nodes.size());
        mesh.nodes.push_back(centre_of(n, mesh.nodes));
      }
      if (element.kind == GmshMesh::line_of_3)
      {
        add(GmshMesh::line, {n[0], n[2]});
        add(GmshMesh::line, {n[2], n[1]});
      }
      else if (element.kind == GmshMesh::quadrilateral_of_8 ||
               element.kind == GmshMesh::quadrilateral_of_9)
        for (unsigned int i = 0; i < 4; ++i) // each has one corner
          add(GmshMesh::quadrilateral, {n[i], n[4 + i], n[8], n[4 + (i + 3) % 4]});
      else
        elements.push_back(std::move(element));
    }
    mesh.elements = std::move(elements);
    return mesh;
  }
} // namespace ringmotor
