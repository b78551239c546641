// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>

#include <vector>

namespace ringmotor
{
  /**
   * The sheets of a conforming hexahedral mesh. Opposite edges of a cell are parallel; the cells
   * that are connected by parallel edges form a sheet, and cutting a whole sheet through the middle
   * of these edges leaves no hanging nodes. Each direction can thus be refined only where it pays.
   * A sheet that reaches one cut of a whole sector continues at the other, and where edges of a
   * shell lie on edges of a solid, it continues from one to the other.
   */
  class Sheets
  {
  public:
    explicit Sheets(const SectorMesh &mesh);

    unsigned int n_sheets() const { return sheet_count; }

    /** The sheet of the edges of @p cell along its reference direction @p direction (0, 1, 2). */
    unsigned int sheet(const dealii::CellAccessor<3> &cell, const unsigned int direction) const;
    /** The same for shell cells (directions 0, 1). */
    unsigned int sheet(const dealii::CellAccessor<2, 3> &cell, const unsigned int direction) const;

    /** Cuts all cells of the sheets that are true in @p chosen; these Sheets are invalid
     * afterwards. */
    void refine(SectorMesh &mesh, const std::vector<bool> &chosen) const;

  private:
    unsigned int sheet_count = 0;
    unsigned int first_shell_line; ///< the lines of the shell follow those of the solids
    std::vector<unsigned int> sheet_of_line;
  };
} // namespace ringmotor
