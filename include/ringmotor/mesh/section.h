// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ringmotor
{
  /**
   * The cross-section of a body in the plane of r and z (m), in quadrilaterals: what is revolved to
   * the mesh of a sector, see revolve(). Parts are the material ids of mesh/ids.h, names of edges
   * its boundary ids.
   */
  struct Section
  {
    struct Cell
    {
      std::array<unsigned int, 4> corners; ///< counterclockwise
      dealii::types::material_id part;
    };
    /** The two ends, the smaller number first. */
    using Edge = std::pair<unsigned int, unsigned int>;

    std::vector<dealii::Point<2>> points;
    std::vector<Cell> cells;
    std::map<Edge, dealii::types::boundary_id> names; ///< of some edges

    /** The line of a shell, from its free end, in contact up to some point, to where it is tied to
     * solids (edges ids::shell_root). */
    struct ShellLine
    {
      std::vector<dealii::Point<2>> points;
      unsigned int n_in_contact = 0; ///< of its segments
    };
    ShellLine shell{}; ///< empty: none

    static Edge edge(const unsigned int a, const unsigned int b)
    {
      return {std::min(a, b), std::max(a, b)};
    }
    /** The edge from a corner of a cell to the next one. */
    static Edge edge(const Cell &cell, const unsigned int corner)
    {
      return edge(cell.corners[corner], cell.corners[(corner + 1) % 4]);
    }

    double length(const Edge &edge) const
    {
      return points[edge.first].distance(points[edge.second]);
    }

    /** The cells at each edge, one or two. */
    std::map<Edge, std::vector<unsigned int>> cells_at_edges() const;

    bool has_part(const dealii::types::material_id part) const;
    bool is_named(const Edge &edge, const dealii::types::boundary_id name) const;
    std::vector<Edge> edges_named(const dealii::types::boundary_id name) const;
    dealii::Point<2> middle(const Cell &cell) const;

    /** An edge of a cell that leads away from another one. */
    struct Across
    {
      unsigned int from, to; ///< points
    };
    /** Both edges of each cell that lead away from its edges with a name. */
    std::vector<Across> edges_across(const dealii::types::boundary_id name) const;

    /** The same without the cells of all parts but one. */
    Section only(const dealii::types::material_id part) const;
  };

  /** The names of parts and edges in files, `base` or `contact`; empty for those without. */
  std::string name_of_part(const dealii::types::material_id part);
  std::string name_of_edge(const dealii::types::boundary_id edge);

  /**
   * Cuts of a section that leave no hanging nodes. Opposite edges of a cell are parallel; those
   * connected in this way form a family, and all of them are cut at the same fractions of their
   * lengths.
   */
  class SectionCuts
  {
  public:
    explicit SectionCuts(const Section &section);

    /** The families are numbered from 0. */
    unsigned int n_families() const { return fractions.size(); }
    unsigned int family(const Section::Edge &edge) const { return place.at(edge).family; }
    /** Whether an edge is directed as its family, from its first to its second end. */
    bool is_along(const Section::Edge &edge) const { return place.at(edge).is_along; }

    /** Cuts the family of the edge between @p from and @p to at these fractions of its length, from
     * @p from. */
    void cut(const unsigned int from, const unsigned int to, const std::vector<double> &at);

    /** The section with all cuts. */
    Section result() const;

  private:
    struct Place
    {
      unsigned int family;
      bool is_along;
    };
    /** Where the edge between two points is cut, from the first one. */
    std::vector<double> cuts_of(const unsigned int from, const unsigned int to) const;

    const Section &section;
    std::map<Section::Edge, Place> place;
    std::vector<std::vector<double>> fractions; ///< by family, ascending, without 0 and 1
  };
} // namespace ringmotor
