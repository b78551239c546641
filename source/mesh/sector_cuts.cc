// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/cells_of.h>
#include <ringmotor/mesh/graded_lines.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/sector_cuts.h>
#include <ringmotor/mesh/sheet_cuts.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  SectorMesh copy_of(const SectorMesh &mesh, const MPI_Comm communicator)
  {
    CellsOf all(mesh);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      all.add(cell);
    return all.mesh(communicator, ids::free);
  }

  SectorMesh tooth_of(const SectorMesh &stator, const MPI_Comm communicator)
  {
    CellsOf cells(stator);
    for (const auto &cell : stator.triangulation->active_cell_iterators())
      if (cell->material_id() == ids::tooth)
        cells.add(cell);
    SectorMesh tooth = cells.mesh(communicator, ids::tooth_foot);
    tooth.has_cuts   = false;
    return tooth;
  }

  namespace
  {
    using Cell = CellsOf::Cell;

    /** @p visit(cell, number of the face) for the faces with an id. */
    template <typename Visit>
    void for_each_face(const SectorMesh &mesh, const types::boundary_id id, const Visit &visit)
    {
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face) && cell->face(face)->boundary_id() == id)
            visit(cell, face);
    }

    /** Chooses the cells on faces, away from them. */
    void choose_on(const SectorMesh &mesh, const types::boundary_id id, SheetCuts &cuts)
    {
      for_each_face(mesh, id,
                    [&](const Cell &cell, const unsigned int face)
                    { cuts.choose(cell, face / 2, face % 2 == 1); });
    }

    /** A line of a face in contact. */
    struct FaceLine
    {
      Cell cell;
      unsigned int face, line; ///< numbers in the cell

      Point<3> end(const unsigned int i) const { return cylindrical(cell->line(line)->vertex(i)); }
      bool is_along_theta() const
      {
        const Tensor<1, 3> along = end(1) - end(0);
        return 0.5 * (end(0)[0] + end(1)[0]) * std::abs(along[1]) > std::abs(along[0]);
      }
      /** Whether the line has a larger coordinate than the middle of the face, between arcs. */
      bool is_beyond_face(const unsigned int coordinate) const
      {
        return 0.5 * (end(0) + end(1))[coordinate] >
               mean_place_of_corners(cell->face(face))[coordinate];
      }
      /** Chooses the cells of the face at the line, away from it. */
      void choose(SheetCuts &cuts) const
      {
        const unsigned int across = 3 - face / 2 - direction_of_line(line);
        cuts.choose(cell, across, is_at_upper_end(line, across));
      }
    };

    /** The lines around the faces with an id. */
    std::vector<FaceLine> outline_of(const SectorMesh &mesh, const types::boundary_id id)
    {
      std::map<unsigned int, std::vector<FaceLine>> at_line;
      for_each_face(mesh, id,
                    [&](const Cell &cell, const unsigned int face)
                    {
                      for (unsigned int i = 0; i < 4; ++i)
                      {
                        const unsigned int line = GeometryInfo<3>::face_to_cell_lines(face, i);
                        at_line[cell->line_index(line)].push_back({cell, face, line});
                      }
                    });
      std::vector<FaceLine> outline;
      for (const auto &[index, lines] : at_line)
        if (lines.size() == 1)
          outline.push_back(lines.front());
      return outline;
    }

    /** Chooses the cells at the outer end of a face in contact. */
    void choose_outermost(const SectorMesh &mesh, const types::boundary_id contact, SheetCuts &cuts)
    {
      for (const FaceLine &line : outline_of(mesh, contact))
        if (line.is_along_theta() && line.is_beyond_face(0))
          line.choose(cuts);
    }

    /** Chooses the cells at the side of a tooth. */
    void choose_side(const SectorMesh &mesh, const types::boundary_id contact, SheetCuts &cuts)
    {
      for (const FaceLine &line : outline_of(mesh, contact))
        if (!line.is_along_theta() && line.is_beyond_face(1))
          line.choose(cuts);
    }

    /** Chooses all cells at a face in contact, along theta. */
    void choose_along_theta(const SectorMesh &mesh, const types::boundary_id contact,
                            SheetCuts &cuts)
    {
      for_each_face(
          mesh, contact,
          [&](const Cell &cell, const unsigned int face)
          {
            for (unsigned int i = 0; i < 4; ++i)
              if (const FaceLine line{cell, face, GeometryInfo<3>::face_to_cell_lines(face, i)};
                  line.is_along_theta())
                cuts.choose_evenly(cell, direction_of_line(line.line));
          });
    }

    /** The angle (rad) of a cell at one of its lines. */
    double angle_at(const Cell &cell, const unsigned int line)
    {
      const unsigned int a = GeometryInfo<3>::line_to_cell_vertices(line, 0),
                         b = GeometryInfo<3>::line_to_cell_vertices(line, 1);
      Tensor<1, 3> along   = cell->vertex(b) - cell->vertex(a);
      along /= along.norm();
      std::vector<Tensor<1, 3>> sides;
      for (const unsigned int bit : {1u, 2u, 4u})
        if ((a ^ bit) != b)
        {
          const Tensor<1, 3> side = cell->vertex(a ^ bit) - cell->vertex(a);
          sides.push_back(side - (side * along) * along);
        }
      const double cosine = sides[0] * sides[1] / (sides[0].norm() * sides[1].norm());
      return std::acos(std::clamp(cosine, -1., 1.));
    }

    /** Indices of lines on outer faces of the body, and not on the planes of the sector. */
    std::set<unsigned int> outer_lines(const SectorMesh &mesh)
    {
      std::set<unsigned int> outer, on_planes;
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face))
          {
            const bool is_plane = ids::is_plane(cell->face(face)->boundary_id());
            for (unsigned int i = 0; i < 4; ++i)
              (is_plane ? on_planes : outer)
                  .insert(cell->line_index(GeometryInfo<3>::face_to_cell_lines(face, i)));
          }
      for (const unsigned int line : on_planes)
        outer.erase(line);
      return outer;
    }

    /** Chooses the cells at re-entrant edges, away from these. */
    void choose_reentrant(const SectorMesh &mesh, SheetCuts &cuts)
    {
      constexpr double least             = 1.1 * numbers::PI; // beyond roundings of straight sides
      const std::set<unsigned int> outer = outer_lines(mesh);
      std::map<unsigned int, double> angles;
      std::map<unsigned int, std::vector<std::pair<Cell, unsigned int>>> cells;
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        for (unsigned int line = 0; line < GeometryInfo<3>::lines_per_cell; ++line)
          if (const unsigned int index = cell->line_index(line); outer.count(index) > 0)
          {
            angles[index] += angle_at(cell, line);
            cells[index].emplace_back(cell, line);
          }
      for (const auto &[index, angle] : angles)
        if (angle > least)
          for (const auto &[cell, line] : cells[index])
            for (unsigned int direction = 0; direction < 3; ++direction)
              if (direction != direction_of_line(line))
                cuts.choose(cell, direction, is_at_upper_end(line, direction));
    }

    /** Cuts what @p choose(cuts) chooses at some @p lines: distances from its side, from 0 to the
     * width of the cells there, 1. */
    template <typename Choose>
    void cut_at(SectorMesh &mesh, const std::vector<double> &lines, const Choose &choose)
    {
      const auto chosen = [&]()
      {
        auto cuts = std::make_unique<SheetCuts>(mesh);
        choose(*cuts);
        return cuts;
      };
      if (lines.size() <= 2)
        return;
      if (const auto cuts = chosen(); cuts->has_two_sided())
        cuts->halve_two_sided();
      for (std::size_t i = lines.size() - 2; i > 0; --i)
        chosen()->cut(lines[i] / lines[i + 1]);
    }
  } // namespace

  void cut_at_contact(SectorMesh &mesh, const types::boundary_id contact,
                      const InterfaceGrading &grading, const AroundContact around)
  {
    const auto lines = [&](const unsigned int n_cells)
    { return lines_from_edge(1., n_cells, grading.ratio); };
    cut_at(mesh, lines(grading.n_across),
           [&](SheetCuts &cuts)
           {
             choose_outermost(mesh, contact, cuts);
             choose_on(mesh, contact, cuts);
           });
    if (around == AroundContact::towards_side)
      cut_at(mesh, lines(grading.n_around),
             [&](SheetCuts &cuts) { choose_side(mesh, contact, cuts); });
    else
      for (unsigned int n = 1; n < grading.n_around; n *= 2)
        cut_at(mesh, {0., 0.5, 1.},
               [&](SheetCuts &cuts) { choose_along_theta(mesh, contact, cuts); });
    cut_at(mesh, lines(grading.n_at_foot),
           [&](SheetCuts &cuts) { choose_on(mesh, ids::tooth_foot, cuts); });
  }

  void cut_at_reentrant_edges(SectorMesh &mesh, const double width, const double ratio)
  {
    if (width < 1.)
      cut_at(mesh, graded_lines(1., width, ratio, 1.),
             [&](SheetCuts &cuts) { choose_reentrant(mesh, cuts); });
  }

  void limit_contact(SectorMesh &mesh, const types::boundary_id contact, const RadialRange &radii)
  {
    for_each_face(mesh, contact,
                  [&](const Cell &cell, const unsigned int face)
                  {
                    const double middle = mean_place_of_corners(cell->face(face))[0];
                    if (middle < radii.inner || middle > radii.outer)
                      cell->face(face)->set_boundary_id(ids::free);
                  });
  }
} // namespace ringmotor
