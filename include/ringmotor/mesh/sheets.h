// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>

#include <vector>

namespace ringmotor
{
  /**
   * The sheets of a conforming hexahedral mesh. Opposite edges of a cell are parallel; the cells
   * that are strung together by parallel edges form a sheet, and cutting a whole sheet through the
   * middle of these edges leaves no hanging nodes. So each direction is refined where, and only
   * where, it pays. On the cuts of a whole sector a sheet goes on on the other side, and where
   * edges of a shell lie on edges of a solid, in the other one of these.
   */
  class Sheets
  {
  public:
    explicit Sheets(const SectorMesh &mesh);

    unsigned int n_sheets() const { return sheet_count; }

    /** The sheet of the edges of @p cell along its reference direction @p direction (0, 1, 2). */
    unsigned int sheet(const dealii::CellAccessor<3> &cell, const unsigned int direction) const;
    /** As well for a shell (0, 1). */
    unsigned int sheet(const dealii::CellAccessor<2, 3> &cell, const unsigned int direction) const;

    /** Cuts all cells of the sheets that are true in @p chosen; these Sheets are void afterwards.
     */
    void refine(SectorMesh &mesh, const std::vector<bool> &chosen) const;

  private:
    unsigned int sheet_count = 0;
    unsigned int first_shell_line; ///< the lines of the shell follow those of the solids
    std::vector<unsigned int> sheet_of_line;
  };
} // namespace ringmotor
