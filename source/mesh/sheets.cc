// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
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

    /** Lines on the faces of one cut with the (r, z) of their midpoints. */
    struct CutLine
    {
      double radius, z;
      unsigned int line;
    };

    std::vector<CutLine> lines_on(const Triangulation<3> &triangulation,
                                  const types::boundary_id cut)
    {
      std::map<unsigned int, CutLine> found;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == cut)
            for (unsigned int i = 0; i < 4; ++i)
            {
              const Point<3> center         = face->line(i)->center();
              found[face->line(i)->index()] = {std::hypot(center[0], center[1]), center[2],
                                               static_cast<unsigned int>(face->line(i)->index())};
            }
      std::vector<CutLine> lines;
      for (const auto &entry : found)
        lines.push_back(entry.second);
      return lines;
    }
  } // namespace

  Sheets::Sheets(const SectorMesh &mesh)
      : sheet_of_line(mesh.triangulation->n_raw_lines(), numbers::invalid_unsigned_int)
  {
    const Triangulation<3> &triangulation = *mesh.triangulation;
    std::vector<unsigned int> rank(triangulation.n_raw_lines(), 0),
        parent(triangulation.n_raw_lines());
    boost::disjoint_sets<unsigned int *, unsigned int *> classes(rank.data(), parent.data());
    for (unsigned int line = 0; line < parent.size(); ++line)
      classes.make_set(line);

    for (const auto &cell : triangulation.active_cell_iterators())
      for (const auto &lines : parallel_lines)
        for (unsigned int i = 1; i < 4; ++i)
          classes.union_set(cell->line_index(lines[0]), cell->line_index(lines[i]));

    if (mesh.form == SectorForm::whole)
    {
      const std::vector<CutLine> low = lines_on(triangulation, ids::cut_low);
      for (const CutLine &high : lines_on(triangulation, ids::cut_high))
      {
        const auto distance = [&](const CutLine &line)
        { return std::hypot(line.radius - high.radius, line.z - high.z); };
        const auto partner = std::min_element(low.begin(), low.end(),
                                              [&](const CutLine &a, const CutLine &b)
                                              { return distance(a) < distance(b); });
        classes.union_set(high.line, partner->line);
      }
    }

    std::map<unsigned int, unsigned int> number;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (unsigned int line = 0; line < 12; ++line)
      {
        const unsigned int root               = classes.find_set(cell->line_index(line));
        sheet_of_line[cell->line_index(line)] = number.emplace(root, number.size()).first->second;
      }
    sheet_count = number.size();
  }

  unsigned int Sheets::sheet(const Cell &cell, const unsigned int direction) const
  {
    return sheet_of_line[cell->line_index(parallel_lines[direction][0])];
  }

  void Sheets::refine(SectorMesh &mesh, const std::vector<bool> &chosen) const
  {
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
    {
      unsigned int cuts = RefinementCase<3>::no_refinement;
      for (unsigned int direction = 0; direction < 3; ++direction)
        if (chosen[sheet(cell, direction)])
          cuts |= RefinementCase<3>::cut_axis(direction);
      if (cuts != RefinementCase<3>::no_refinement)
        cell->set_refine_flag(
            RefinementCase<3>(static_cast<RefinementPossibilities<3>::Possibilities>(cuts)));
    }
    mesh.triangulation->execute_coarsening_and_refinement();
  }
} // namespace ringmotor
