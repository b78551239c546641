// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ringmotor
{
  /** A scalar or a vector at the points of a grid. */
  struct PointField
  {
    std::string name, unit;
    unsigned int n_components;
    std::vector<float> values; ///< components of a point one after the other
  };

  /** Types of cells, numbered by VTK. */
  enum class VtuCell : std::uint8_t
  {
    hexahedron          = 12,
    lagrange_hexahedron = 72
  };

  /**
   * The points and cells of VTU files as compressed text, made once for all files of a grid that
   * differ in their fields only. Cells share their points, unlike in deal.II's own writer, which
   * takes several times the space and time.
   */
  class VtuGrid
  {
  public:
    /** @param points m
     *  @param cells points of all cells in the order of VTK, one cell after the other
     *  @param points_per_cell the same for all */
    VtuGrid(const std::vector<dealii::Point<3>> &points, const std::vector<std::int32_t> &cells,
            const unsigned int points_per_cell, const VtuCell type);

    /** Adds a field that all files have. */
    void add(const PointField &field);

    /** Writes a file with the common fields and these.
     * @throw UserError if writing fails */
    void write(const std::string &path, const std::vector<PointField> &fields) const;

  private:
    std::size_t n_points, n_cells;
    std::string points_and_cells, common_fields;
  };
} // namespace ringmotor
