// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/mesh/graded_lines.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/merged_section.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/revolved.h>
#include <ringmotor/mesh/section_layers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Cuts the edges between two points into even cells. */
    void cut_evenly(SectionCuts &cuts, const unsigned int from, const unsigned int to,
                    const unsigned int n_cells)
    {
      cuts.cut(from, to, lines_from_edge(1., n_cells, 1.));
    }

    /** The lines of cells that get thinner towards both ends, where slots end freely. */
    std::vector<double> lines_between_ends(const unsigned int n_cells)
    {
      std::vector<double> lines;
      for (unsigned int i = 0; i <= n_cells; ++i)
        lines.push_back(0.5 * (1. - std::cos(i * numbers::PI / n_cells)));
      return lines;
    }

    /** The section and the lines along theta of a body's sector. */
    class BodyCells
    {
    public:
      BodyCells(const RevolvedBody &body, const SectorGrading &grading)
          : body(body), grading(grading), half_slot(body.slots.half_width()),
            half_tooth(body.slots.half_pitch() * body.slots.inner_radius - half_slot)
      {
      }

      Section section() const
      {
        const Section along = cut_along_roots(body.section);
        if (grading.even)
          return cut_evenly_across(along);
        const SectionPoints corners = singular_points(along);
        SectionGrading cells(along);
        cells.grow_from(corners, 1., {0.3, 1.});
        const std::vector<FromRoot> edges = edges_from_roots(along);
        const double first                = narrowest(edges);
        for (const FromRoot &edge : edges)
          cells.grow(edge.root, edge.opposite, first / edge.depth, {});
        return with_layers(cells.result(), corners, grading.n_layers, grading.ratio);
      }

      std::vector<double> lines() const
      {
        if (!body.slots.has_teeth())
          return {0., 1.};
        const double first   = narrowest(edges_from_roots(body.section));
        const auto from_side = [&](const double length, unsigned int EvenCells::*const n_even)
        {
          std::vector<double> lines = grading.even
                                          ? lines_from_edge(length, *grading.even.*n_even, 1.)
                                          : graded_lines(length, first);
          for (double &line : lines)
            line /= length;
          return lines;
        };
        std::vector<double> lines;
        for (const double line : from_side(half_tooth, &EvenCells::n_tooth))
          lines.insert(lines.begin(), 1. - line);
        for (const double line : from_side(half_slot, &EvenCells::n_slot))
          if (line > 0.)
            lines.push_back(1. + line);
        return lines;
      }

    private:
      /** An edge that leads away from a root. */
      struct FromRoot
      {
        unsigned int root, opposite; ///< points
        double depth;                ///< m, distance of the opposite one from the root's line
        types::material_id part;
      };

      static std::vector<FromRoot> edges_from_roots(const Section &section)
      {
        const RootEdges roots = root_edges(section);
        std::vector<FromRoot> edges;
        for (unsigned int number = 0; number < section.cells.size(); ++number)
          if (const unsigned int i = roots.of_cells[number]; i != RootEdges::none)
          {
            const Section::Cell &cell = section.cells[number];
            const auto corner     = [&](const unsigned int j) { return cell.corners[(i + j) % 4]; };
            const Point<2> &begin = section.points[corner(0)];
            const Tensor<1, 2> root   = section.points[corner(1)] - begin;
            const Tensor<1, 2> across = cross_product_2d(root) / root.norm();
            for (const auto &[from, to] :
                 {std::make_pair(corner(0), corner(3)), {corner(1), corner(2)}})
              edges.push_back(
                  {from, to, std::abs((section.points[to] - begin) * across), cell.part});
          }
        return edges;
      }

      /** The size of the cells at a root: what is narrowest around it, m. */
      double narrowest(const std::vector<FromRoot> &edges) const
      {
        double narrowest = std::min(half_slot, half_tooth);
        for (const FromRoot &edge : edges)
          narrowest = std::min(narrowest, edge.depth);
        return narrowest;
      }

      /** Enough cells along the feet of the teeth. */
      Section cut_along_roots(const Section &section) const
      {
        const std::vector<Section::Edge> feet = feet_of_teeth(section);
        SectionCuts cuts(section);
        for (const Section::Edge &foot : feet)
          if (feet.size() == 1 && !grading.even)
            cuts.cut(foot.first, foot.second, lines_between_ends(grading.n_radial));
          else
            cut_evenly(cuts, foot.first, foot.second,
                       (grading.n_radial + feet.size() - 1) / feet.size());
        return cuts.result();
      }

      Section cut_evenly_across(const Section &section) const
      {
        SectionCuts cuts(section);
        for (const FromRoot &edge : edges_from_roots(section))
          cut_evenly(cuts, edge.root, edge.opposite,
                     edge.part == ids::tooth ? grading.even->n_above : grading.even->n_below);
        return cuts.result();
      }

      const RevolvedBody &body;
      const SectorGrading &grading;
      const double half_slot, half_tooth; ///< m, at the inner radius of the teeth
    };

    SectorMesh revolved(const RevolvedBody &body, const SectorForm form, const SectorParts parts,
                        const SectorGrading &grading, MPI_Comm communicator)
    {
      const BodyCells cells(body, grading);
      Revolution revolution{form, parts, cells.lines(), grading.even ? 0 : grading.n_layers,
                            grading.ratio};
      if (parts == SectorParts::tooth)
        while (revolution.lines.back() > 1.)
          revolution.lines.pop_back();
      return revolve(cells.section(), body.slots, revolution, communicator);
    }

    /** Bonds the ceramic ring, a shell, to the faces marked as skin. */
    void add_skin(SectorMesh &mesh, const RevolvedBody &stator)
    {
      std::vector<Point<3>> vertices;
      std::vector<CellData<2>> cells;
      std::map<unsigned int, unsigned int> new_number;
      for (const auto &face : mesh.triangulation->active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == ids::skin)
        {
          cells.emplace_back();
          cells.back().material_id = ids::piezoceramic;
          for (const unsigned int i : face->vertex_indices())
          {
            const auto [entry, is_new] = new_number.emplace(face->vertex_index(i), vertices.size());
            if (is_new)
              vertices.push_back(face->vertex(i));
            cells.back().vertices[i] = entry->second;
          }
        }
      add_shell(mesh, vertices, cells);
      mesh.sections[ids::piezoceramic] = {stator.skin_thickness, -0.5 * stator.skin_thickness};
      mesh.shell->set_all_manifold_ids(0);
      mesh.shell->set_manifold(0, RevolvedManifold<2>(stator.slots));
    }
  } // namespace

  SectorMesh make_sector(const RevolvedBody &body, const SectorForm form,
                         const SectorGrading &grading, MPI_Comm communicator)
  {
    SectorMesh mesh = revolved(body, form, SectorParts::all, grading, communicator);
    if (body.skin_thickness > 0.)
      add_skin(mesh, body);
    return mesh;
  }

  SectorMesh make_tooth(const RevolvedBody &stator, const SectorGrading &grading,
                        MPI_Comm communicator)
  {
    SectorMesh mesh = revolved(stator, SectorForm::half, SectorParts::tooth, grading, communicator);
    for (const auto &face : mesh.triangulation->active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == ids::tooth_foot)
        face->set_boundary_id(ids::clamped);
    return mesh;
  }

  namespace
  {
    /** Radii of the lines across the tops of teeth from @p begin to @p end (m), finer at the outer
     * edge of the strip that the lip covers. */
    std::vector<double> lines_across(const double begin, const double end, const double lip_inner,
                                     const double lip_outer, const InterfaceGrading &grading)
    {
      const double inner = std::max(lip_inner, begin), outer = std::min(lip_outer, end);
      std::vector<double> radii;
      for (const double distance : lines_from_edge(outer - inner, grading.n_across, grading.ratio))
        radii.push_back(outer - distance);
      if (inner > begin)
        for (const double distance : lines_from_edge(inner - begin, 2, grading.ratio))
          radii.push_back(inner - distance);
      if (outer < end)
        for (const double distance :
             lines_from_edge(end - outer, std::max(2u, grading.n_across), grading.ratio))
          radii.push_back(outer + distance);
      return radii;
    }

    /** Cuts a tooth's section across the contact, and leaves the name of the tops to what the lip
     * covers. */
    Section cut_across_contact(const Section &tooth, const double lip_inner, const double lip_outer,
                               const InterfaceGrading &grading)
    {
      const std::vector<Section::Edge> tops = tooth.edges_named(ids::tooth_top);
      double begin = std::numeric_limits<double>::max(), end = 0.;
      for (const Section::Edge &top : tops)
        for (const unsigned int point : {top.first, top.second})
        {
          begin = std::min(begin, tooth.points[point][0]);
          end   = std::max(end, tooth.points[point][0]);
        }
      SectionCuts cuts(tooth);
      for (const Section::Edge &top : tops)
      {
        const double from = tooth.points[top.first][0], to = tooth.points[top.second][0];
        std::vector<double> fractions;
        for (const double radius : lines_across(begin, end, lip_inner, lip_outer, grading))
          if (const double fraction = (radius - from) / (to - from); fraction > 0. && fraction < 1.)
            fractions.push_back(fraction);
        cuts.cut(top.first, top.second, fractions);
      }
      Section cut = cuts.result();
      for (const Section::Edge &top : cut.edges_named(ids::tooth_top))
        if (const double radius = 0.5 * (cut.points[top.first][0] + cut.points[top.second][0]);
            radius < lip_inner || radius > lip_outer)
          cut.names[top] = ids::free;
      return cut;
    }

    /** Cuts it along its height: cells shrink towards the top and, if there are several, those at
     * the foot towards it. */
    Section cut_along_height(const Section &tooth, const InterfaceGrading &grading)
    {
      SectionCuts from_top(tooth);
      for (const types::boundary_id name : {ids::tooth_top, ids::free})
        for (const Section::Across &edge : tooth.edges_across(name))
          from_top.cut(edge.from, edge.to,
                       lines_from_edge(1., grading.n_across + 1, grading.ratio));
      const Section cut = from_top.result();
      SectionCuts from_foot(cut);
      for (const Section::Across &edge : cut.edges_across(ids::tooth_foot))
        from_foot.cut(edge.from, edge.to, lines_from_edge(1., grading.n_at_foot, grading.ratio));
      return from_foot.result();
    }
  } // namespace

  SectorMesh make_contact_tooth(const RevolvedBody &stator, const double lip_inner,
                                const double lip_outer, const InterfaceGrading &grading,
                                MPI_Comm communicator)
  {
    Section tooth = stator.section;
    for (const Section::Edge &foot : feet_of_teeth(tooth))
      tooth.names[foot] = ids::tooth_foot;
    tooth = without_lines_from(ids::tooth_top, tooth.only(ids::tooth));
    tooth = cut_along_height(cut_across_contact(tooth, lip_inner, lip_outer, grading), grading);
    Revolution revolution{SectorForm::half, SectorParts::tooth, {}, 0};
    for (const double distance : lines_from_edge(1., grading.n_around, grading.ratio))
      revolution.lines.insert(revolution.lines.begin(), 1. - distance);
    return revolve(tooth, stator.slots, revolution, communicator);
  }
} // namespace ringmotor
