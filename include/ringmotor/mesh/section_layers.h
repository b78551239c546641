// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/section.h>

#include <optional>
#include <set>
#include <vector>

namespace ringmotor
{
  /** Points of a section. */
  using SectionPoints = std::set<unsigned int>;

  /** Where stresses are singular whatever the loads: re-entrant corners of the section of teeth or
   * of slots, where the part ids::tooth is missing, and ends of clamped edges. */
  SectionPoints singular_points(const Section &section);

  /** How cells grow from an edge. */
  struct Growth
  {
    double ratio   = 0.3; ///< of the distances of successive lines from the edge
    double longest = 0.6; ///< cell, over the length along which they grow
  };

  /** Collects from where cells of a section are to grow, and cuts it so. */
  class SectionGrading
  {
  public:
    explicit SectionGrading(const Section &section);

    /** Cells along the edge from @p from to @p to grow from a size of @p share of it on; where
     * cells are to grow from its other end, too, each half does. */
    void grow(const unsigned int from, const unsigned int to, const double share,
              const Growth &growth);

    /** The same along all edges at these points, from a size of @p share of the shortest edge there
     * or, where it is known, of what is @p thinnest (m). Of any two points of a cell, each gets
     * cells of its own. */
    void grow_from(const SectionPoints &points, const double share, const Growth &growth,
                   const std::optional<double> &thinnest = {});

    /** The same with so many cells, of which successive distances from @p from have a @p ratio. */
    void shrink(const unsigned int from, const unsigned int to, const unsigned int n_cells,
                const double ratio);

    /** Cuts an edge at these fractions of its length, from @p from; it does not grow. */
    void cut(const unsigned int from, const unsigned int to, const std::vector<double> &at);

    Section result() const;

  private:
    const Section &section;
    SectionCuts cuts;
    struct Wanted
    {
      double share;                    ///< of the length of the edge
      std::vector<double> whole, half; ///< lines, if they cover the whole edge or one half
    };
    void want(const unsigned int from, const unsigned int to, const Wanted &lines);

    struct Family
    {
      std::optional<Wanted> at_begin, at_end;
      bool is_cut = false;
    };
    std::vector<Family> families;
  };

  /**
   * Nests layers of cells around points, at each of which the distances decrease by @p ratio.
   * Within a cell, layers are two trapezoids each, and its other edges stay as they are; no cell
   * may have two of the points.
   */
  Section with_layers(const Section &section, const SectionPoints &points,
                      const unsigned int n_layers, const double ratio);
} // namespace ringmotor
