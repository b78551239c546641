// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/cells_of.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/sheet_cuts.h>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int dim = 3;

    /** A corner of a cell's line; numbers of corners have one bit for each direction. */
    unsigned int corner_of(const unsigned int line, const bool is_upper)
    {
      const unsigned int a = GeometryInfo<dim>::line_to_cell_vertices(line, 0),
                         b = GeometryInfo<dim>::line_to_cell_vertices(line, 1);
      return (a < b) == is_upper ? b : a;
    }
  } // namespace

  unsigned int direction_of_line(const unsigned int line)
  {
    const unsigned int bit = corner_of(line, true) - corner_of(line, false);
    return bit == 1 ? 0 : bit == 2 ? 1 : 2;
  }

  bool is_at_upper_end(const unsigned int line, const unsigned int direction)
  {
    return (corner_of(line, false) >> direction & 1) == 1;
  }

  SheetCuts::SheetCuts(SectorMesh &mesh) : mesh(mesh), sheets(mesh) {}

  void SheetCuts::note(const Cell &cell, const unsigned int direction, const bool is_upper)
  {
    for (unsigned int line = 0; line < GeometryInfo<dim>::lines_per_cell; ++line)
      if (direction_of_line(line) == direction)
      {
        const unsigned int end     = cell->vertex_index(corner_of(line, is_upper));
        const auto [known, is_new] = near_end.emplace(cell->line_index(line), end);
        if (!is_new && known->second != end)
          two_sided.insert(sheets.sheet(*cell, direction));
      }
  }

  void SheetCuts::choose(const Cell &cell, const unsigned int direction, const bool at_upper_end)
  {
    chosen.insert(sheets.sheet(*cell, direction));
    note(cell, direction, at_upper_end);
    is_spread = false;
  }

  void SheetCuts::choose_evenly(const Cell &cell, const unsigned int direction)
  {
    chosen.insert(sheets.sheet(*cell, direction));
  }

  void SheetCuts::spread()
  {
    for (std::size_t n_known = 0; !is_spread && n_known != near_end.size();)
    {
      n_known = near_end.size();
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        for (unsigned int line = 0; line < GeometryInfo<dim>::lines_per_cell; ++line)
          if (const auto known = near_end.find(cell->line_index(line)); known != near_end.end())
            note(cell, direction_of_line(line),
                 known->second == cell->vertex_index(corner_of(line, true)));
    }
    is_spread = true;
  }

  bool SheetCuts::has_two_sided()
  {
    spread();
    return !two_sided.empty();
  }

  void SheetCuts::halve_two_sided()
  {
    spread();
    near_end.clear();
    divide(two_sided, 0.5);
  }

  void SheetCuts::cut(const double fraction)
  {
    Assert(!has_two_sided(), ExcInternalError());
    spread();
    divide(chosen, fraction);
  }

  void SheetCuts::divide(const std::set<unsigned int> &divided, const double fraction)
  {
    CellsOf cells(mesh);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
    {
      CellsOf::Lines lines{{{0., 1.}, {0., 1.}, {0., 1.}}};
      for (unsigned int line = 0; line < GeometryInfo<dim>::lines_per_cell; ++line)
      {
        const unsigned int direction = direction_of_line(line);
        if (divided.count(sheets.sheet(*cell, direction)) == 0)
          continue;
        const auto end = near_end.find(cell->line_index(line));
        const bool is_upper =
            end != near_end.end() && end->second == cell->vertex_index(corner_of(line, true));
        lines[direction] = {0., is_upper ? 1. - fraction : fraction, 1.};
      }
      cells.add(cell, lines);
    }
    mesh = cells.mesh(mesh.triangulation->get_communicator(), ids::free);
  }
} // namespace ringmotor
