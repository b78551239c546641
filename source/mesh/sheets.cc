// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/sheets.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Lines of the reference hexahedron along each direction, in deal.II's numbering. */
    constexpr std::array<std::array<unsigned int, 4>, 3> parallel_lines{
        {{{2, 3, 6, 7}}, {{0, 1, 4, 5}}, {{8, 9, 10, 11}}}};
    /** Of the reference quadrilateral. */
    constexpr std::array<std::array<unsigned int, 2>, 2> parallel_sides{{{{2, 3}}, {{0, 1}}}};

    using Classes = boost::disjoint_sets<unsigned int *, unsigned int *>;

    /** A line with its midpoint, or a projection of it: lines with the same point are joined. */
    struct PlacedLine
    {
      Point<3> place;
      unsigned int line;
    };

    void join_coincident(Classes &classes, const std::vector<PlacedLine> &lines,
                         const std::vector<PlacedLine> &others)
    {
      for (const PlacedLine &line : lines)
        for (const PlacedLine &other : others)
          if (is_same_place(line.place.distance(other.place), 0., line.place.norm()))
            classes.union_set(line.line, other.line);
    }

    /** (r, z) */
    Point<3> meridian(const Point<3> &x)
    {
      return Point<3>(std::hypot(x[0], x[1]), 0., x[2]);
    }

    /** The lines of solid and shell on one cut. */
    std::vector<PlacedLine> lines_on(const SectorMesh &mesh, const types::boundary_id cut,
                                     const unsigned int first_shell_line)
    {
      std::vector<PlacedLine> lines;
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == cut)
            for (unsigned int i = 0; i < 4; ++i)
              lines.push_back({meridian(face->line(i)->center()), face->line_index(i)});
      if (mesh.shell)
        for (const auto &cell : mesh.shell->active_cell_iterators())
          for (const auto &edge : cell->face_iterators())
            if (edge->at_boundary() && edge->boundary_id() == cut)
              lines.push_back({meridian(edge->center()),
                               first_shell_line + static_cast<unsigned int>(edge->index())});
      return lines;
    }

    /** The lines of a mesh of solid or shell cells. */
    template <int dim>
    std::vector<PlacedLine> all_lines(const Triangulation<dim, 3> &triangulation,
                                      const unsigned int first_line)
    {
      std::vector<PlacedLine> lines;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int line : cell->line_indices())
          lines.push_back({cell->line(line)->center(), first_line + cell->line_index(line)});
      return lines;
    }
  } // namespace

  Sheets::Sheets(const SectorMesh &mesh) : first_shell_line(mesh.triangulation->n_raw_lines())
  {
    const unsigned int n_lines = first_shell_line + (mesh.shell ? mesh.shell->n_raw_lines() : 0);
    std::vector<unsigned int> rank(n_lines, 0), parent(n_lines);
    Classes classes(rank.data(), parent.data());
    for (unsigned int line = 0; line < n_lines; ++line)
      classes.make_set(line);

    std::vector<PlacedLine> lines = all_lines(*mesh.triangulation, 0);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &parallel : parallel_lines)
        for (unsigned int i = 1; i < 4; ++i)
          classes.union_set(cell->line_index(parallel[0]), cell->line_index(parallel[i]));
    if (mesh.shell)
    {
      for (const auto &cell : mesh.shell->active_cell_iterators())
        for (const auto &parallel : parallel_sides)
          classes.union_set(first_shell_line + cell->line_index(parallel[0]),
                            first_shell_line + cell->line_index(parallel[1]));
      const std::vector<PlacedLine> of_shell = all_lines(*mesh.shell, first_shell_line);
      join_coincident(classes, of_shell, lines);
      lines.insert(lines.end(), of_shell.begin(), of_shell.end());
    }
    if (mesh.form == SectorForm::whole)
      join_coincident(classes, lines_on(mesh, ids::cut_low, first_shell_line),
                      lines_on(mesh, ids::cut_high, first_shell_line));

    sheet_of_line.assign(n_lines, numbers::invalid_unsigned_int);
    std::map<unsigned int, unsigned int> number;
    for (const PlacedLine &line : lines)
      sheet_of_line[line.line] =
          number.emplace(classes.find_set(line.line), number.size()).first->second;
    sheet_count = number.size();
  }

  unsigned int Sheets::sheet(const CellAccessor<3> &cell, const unsigned int direction) const
  {
    return sheet_of_line[cell.line_index(parallel_lines[direction][0])];
  }

  unsigned int Sheets::sheet(const CellAccessor<2, 3> &cell, const unsigned int direction) const
  {
    return sheet_of_line[first_shell_line + cell.line_index(parallel_sides[direction][0])];
  }

  namespace
  {
    template <int dim, typename Chosen>
    void refine_cells(Triangulation<dim, 3> &triangulation, const Chosen &is_chosen)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
      {
        unsigned int cuts = RefinementCase<dim>::no_refinement;
        for (unsigned int direction = 0; direction < dim; ++direction)
          if (is_chosen(cell, direction))
            cuts |= RefinementCase<dim>::cut_axis(direction);
        if (cuts != RefinementCase<dim>::no_refinement)
          cell->set_refine_flag(RefinementCase<dim>(
              static_cast<typename RefinementPossibilities<dim>::Possibilities>(cuts)));
      }
      triangulation.execute_coarsening_and_refinement();
    }
  } // namespace

  void Sheets::refine(SectorMesh &mesh, const std::vector<bool> &chosen) const
  {
    const auto is_chosen = [&](const auto &cell, const unsigned int direction)
    { return chosen[sheet(*cell, direction)]; };
    refine_cells(*mesh.triangulation, is_chosen);
    if (mesh.shell)
      refine_cells(*mesh.shell, is_chosen);
  }
} // namespace ringmotor
