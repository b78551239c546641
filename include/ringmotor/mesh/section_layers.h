// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/section.h>

#include <set>
#include <vector>

namespace ringmotor
{
  /** Points of a section. */
  using SectionPoints = std::set<unsigned int>;

  /** Where stresses are singular whatever the loads: re-entrant corners of the section of teeth or
   * of slots, where the part ids::tooth is missing, and ends of clamped edges. */
  SectionPoints singular_points(const Section &section);

  /** Collects from where cells of a section are to grow, and cuts it so. */
  class SectionGrading
  {
  public:
    explicit SectionGrading(const Section &section);

    /** Cells along the edge from @p from to @p to grow from a size of @p share of it on, in both
     * directions if the same is wanted at its other end. */
    void grow(const unsigned int from, const unsigned int to, const double share);

    /** The same along all edges at these points, from a size of the shortest edge at each. Of any
     * two points of a cell, one gets cells of its own. */
    void grow_from(const SectionPoints &points);

    Section result() const;

  private:
    const Section &section;
    SectionCuts cuts;
    struct Wanted
    {
      double at_begin = 0., at_end = 0.; ///< size over the length of the edge; 0: any
    };
    std::vector<Wanted> wanted; ///< by family
  };

  /**
   * Nests layers of cells around points, at each of which the distances decrease by @p ratio.
   * Within a cell, layers are two trapezoids each, and its other edges stay as they are; no cell
   * may have two of the points.
   */
  Section with_layers(const Section &section, const SectionPoints &points,
                      const unsigned int n_layers, const double ratio);
} // namespace ringmotor
