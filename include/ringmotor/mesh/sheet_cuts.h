// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/mesh/sheets.h>

#include <map>
#include <set>

namespace ringmotor
{
  /**
   * Cuts sheets of the solids of a mesh, see Sheets, at a distance from one of their sides instead
   * of in the middle, so that cells can shrink towards it. For new vertices see CellsOf.
   */
  class SheetCuts
  {
  public:
    using Cell = dealii::Triangulation<3>::active_cell_iterator;

    /** @pre see CellsOf. @p mesh must outlive this object, which is invalid once the mesh is cut.
     */
    explicit SheetCuts(SectorMesh &mesh);

    /** Chooses the sheet of the edges of a cell along a reference direction, and its side at the
     * lower or upper end of these edges. */
    void choose(const Cell &cell, const unsigned int direction, const bool at_upper_end);
    /** The same for a sheet that is only halved. */
    void choose_evenly(const Cell &cell, const unsigned int direction);

    /** Whether a sheet has been chosen on both sides. */
    bool has_two_sided();
    /** Halves those that have. */
    void halve_two_sided();

    /** Cuts the chosen sheets at a fraction of their width from the chosen side.
     * @pre not has_two_sided() */
    void cut(const double fraction);

  private:
    /** Tells all cells of the chosen sheets the side. */
    void spread();
    void note(const Cell &cell, const unsigned int direction, const bool is_upper);

    void divide(const std::set<unsigned int> &divided, const double fraction);

    SectorMesh &mesh;
    const Sheets sheets;
    std::map<unsigned int, unsigned int> near_end; ///< vertex, by line
    std::set<unsigned int> chosen, two_sided;      ///< sheets
    bool is_spread = false;
  };

  /** The direction of one of a cell's lines, and whether it lies at the upper end of another
   * direction. */
  unsigned int direction_of_line(const unsigned int line);
  bool is_at_upper_end(const unsigned int line, const unsigned int direction);
} // namespace ringmotor
