// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/mesh_file.h>

#include <deal.II/base/point.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ringmotor
{
  /** What a file in Gmsh's format says: nodes, and elements of volumes, surfaces and curves. */
  struct GmshMesh
  {
    enum Kind : long ///< Gmsh's numbers
    {
      line          = 1,
      triangle      = 2,
      quadrilateral = 3,
      tetrahedron   = 4,
      hexahedron    = 5,
      prism         = 6,
      pyramid       = 7,
      point         = 15,
      // Of second order; nodes of an element are its corners, the middles of its sides, its centre.
      line_of_3          = 8,
      quadrilateral_of_9 = 10,
      quadrilateral_of_8 = 16
    };

    struct Element
    {
      long kind;                       ///< any, also those that Kind lacks
      long id;                         ///< physical id, 0: none
      std::vector<unsigned int> nodes; ///< their places in GmshMesh::nodes; empty for kinds that
                                       ///< Kind lacks
    };

    MeshFile file;
    std::vector<dealii::Point<3>> nodes;
    std::vector<Element> elements; ///< an element with several physical ids once for each of them
    bool has_partitions = false;   ///< Gmsh has divided it for several processes
    /** Names of physical ids, by dimension and id. */
    std::map<std::pair<long, long>, std::string> names;

    /** The name of the physical id of an element of this dimension, or nothing. */
    std::string name_of(const long dimension, const Element &element) const
    {
      const auto found = names.find({dimension, element.id});
      return found == names.end() ? "" : found->second;
    }
  };

  /**
   * Reads a file in Gmsh's ASCII format of version 1, 2 to 2.2 or 4.1. Sections that say nothing of
   * nodes, elements and physical ids are skipped, and so are points, partitions and parametric
   * coordinates. Physical ids that Gmsh has given to partitions count as those of the
   * volumes and surfaces that were divided.
   *
   * @throws UserError for files that cannot be opened, other formats and versions, and for damaged
   *         files: sections that do not have the lines that they announce, lines that do not have
   *         the numbers that they should, and elements of nodes that are not in the file.
   */
  GmshMesh read_gmsh(const MeshFile &file);
} // namespace ringmotor
