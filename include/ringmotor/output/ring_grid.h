// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/warp.h>
#include <ringmotor/output/vtu_file.h>
#include <ringmotor/pictures/sector_field.h>

#include <memory>
#include <string>
#include <vector>

namespace ringmotor
{
  /**
   * The whole ring of a sector's motion as Lagrange cells, for one or more VTU files. Cells of the
   * same material share their points; where two materials meet, each has its own.
   */
  class RingGrid
  {
  public:
    /** @param field has to outlive this object */
    explicit RingGrid(const SectorField &field);

    /** Writes the motion at a time, on a warp at rest. Point fields: `displacement` (Cartesian
     * vector, m) and `material`.
     * @param time_angle omega t
     * @throw UserError if writing fails */
    void write(const std::string &path, const double time_angle, const Warp &warp) const;

  private:
    struct Place
    {
      std::size_t cell;
      unsigned int point; ///< of the cell's lattice
    };

    double angle_of(const unsigned int sector) const;

    const SectorField &field;
    std::vector<Place> own; ///< points of a sector, without those of the sector before
    std::unique_ptr<VtuGrid> grid;
  };
} // namespace ringmotor
