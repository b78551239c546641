// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/graded_lines.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/sector_manifold.h>
#include <ringmotor/mesh/stator_sector.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Whether the ceramic ring is a shell. */
    bool has_skin(const StatorGeometry &stator)
    {
      return stator.piezoceramic_thickness > 0. &&
             stator.piezoceramic_element == ElementKind::shell;
    }

    enum class Parts
    {
      all,
      tooth
    };

    /**
     * The section across the tooth in the chart's plane (s, z), in quadrilaterals: rectangles that
     * grow away from the slot root, and the three that meet there cut into angles around it.
     */
    class Section
    {
    public:
      /** @param parts whether only the tooth above its foot is wanted */
      Section(const StatorGeometry &stator, const unsigned int n_teeth, const SectorForm form,
              const SectorGrading &grading, const Parts parts)
          : grading(grading), whole(form == SectorForm::whole), scale(stator.base_thickness)
      {
        const double half_slot  = 0.5 * stator.slot_width;
        const double half_tooth = numbers::PI * stator.base_inner_radius / n_teeth - half_slot;
        const double first =
            std::min({half_slot, half_tooth, stator.tooth_height, stator.base_thickness});
        const auto lines_from_root = [&](const double length, unsigned int EvenCells::*const n_even)
        {
          return grading.even ? lines_from_edge(length, *grading.even.*n_even, 1.)
                              : graded_lines(length, first);
        };
        // Towards the tooth's centre s falls from 1 to 0, towards the cut it rises to 2.
        const auto s_lines =
            [&](const double width, const double sign, unsigned int EvenCells::*const n_even)
        {
          std::vector<double> lines = lines_from_root(width, n_even);
          for (double &line : lines)
            line = 1. + sign * line / width;
          return lines;
        };
        const auto z_lines =
            [&](const double height, const double sign, unsigned int EvenCells::*const n_even)
        {
          std::vector<double> lines = lines_from_root(height, n_even);
          for (double &line : lines)
            line = stator.base_thickness + sign * line;
          return lines;
        };
        const std::vector<double> tooth = s_lines(half_tooth, -1., &EvenCells::n_tooth),
                                  slot  = s_lines(half_slot, 1., &EvenCells::n_slot),
                                  above = z_lines(stator.tooth_height, 1., &EvenCells::n_above),
                                  below = z_lines(stator.base_thickness, -1., &EvenCells::n_below);
        add_quadrant(tooth, above, ids::tooth);
        if (parts == Parts::tooth)
          return;
        for (const std::vector<double> &across : {tooth, slot})
        {
          add_quadrant(across, below, ids::base);
          if (stator.piezoceramic_thickness > 0. &&
              stator.piezoceramic_element == ElementKind::solid)
            for (unsigned int i = 0; i + 1 < across.size(); ++i)
              add_rectangle({across[i], -stator.piezoceramic_thickness}, {across[i + 1], 0.},
                            ids::piezoceramic);
        }
      }

      /** Makes @p plane the triangulation of the section. */
      void triangulate(Triangulation<2> &plane)
      {
        SubCellData no_lines;
        std::vector<unsigned int> all_vertices;
        GridTools::delete_duplicated_vertices(vertices, cells, no_lines, all_vertices,
                                              places::rounding);
        GridTools::consistently_order_cells(cells);
        plane.create_triangulation(vertices, cells, no_lines);
        GridTools::transform(
            [&](const Corner &corner) { return Corner(corner[0], corner[1] * scale); }, plane);
      }

    private:
      using Corner = Point<2>;

      /** The rectangles between lines that lead away from the root. */
      void add_quadrant(const std::vector<double> &s_lines, const std::vector<double> &z_lines,
                        const types::material_id material)
      {
        for (unsigned int i = 0; i + 1 < s_lines.size(); ++i)
          for (unsigned int j = 0; j + 1 < z_lines.size(); ++j)
          {
            const Corner near(s_lines[i], z_lines[j]), far(s_lines[i + 1], z_lines[j + 1]);
            if (i == 0 && j == 0)
              add_graded_rectangle(near, far, material);
            else
              add_rectangle(near, far, material);
          }
      }

      /** Two trapezoids for each layer, and around the root what remains of the rectangle. */
      void add_graded_rectangle(const Corner &root, const Corner &far,
                                const types::material_id material)
      {
        Corner outer = far;
        for (unsigned int layer = 0; layer < grading.n_layers; ++layer)
        {
          const Corner inner = root + grading.ratio * (outer - root);
          add({inner[0], root[1]}, {outer[0], root[1]}, outer, inner, material);
          add({root[0], inner[1]}, inner, outer, {root[0], outer[1]}, material);
          outer = inner;
        }
        add_rectangle(root, outer, material);
      }

      void add_rectangle(const Corner &a, const Corner &b, const types::material_id material)
      {
        add(a, {b[0], a[1]}, b, {a[0], b[1]}, material);
      }

      /** A cell with these corners, in order around it in either sense, and its mirror image. */
      void add(const Corner &a, const Corner &b, const Corner &c, const Corner &d,
               const types::material_id material)
      {
        for (const double side : {1., -1.})
          if (side > 0. || whole)
          {
            const Tensor<1, 2> ac = c - a, bd = d - b;
            const bool clockwise = side * (ac[0] * bd[1] - ac[1] * bd[0]) < 0.;
            const unsigned int v = vertices.size();
            for (const Corner &corner : {a, b, c, d})
              vertices.emplace_back(side * corner[0], corner[1] / scale);
            CellData<2> cell;
            cell.vertices    = clockwise ? std::vector<unsigned int>{v, v + 3, v + 1, v + 2}
                                         : std::vector<unsigned int>{v, v + 1, v + 3, v + 2};
            cell.material_id = material;
            cells.push_back(cell);
          }
      }

      const SectorGrading grading;
      const bool whole;
      const double scale; ///< of z, so that both coordinates are of order 1
      std::vector<Corner> vertices;
      std::vector<CellData<2>> cells;
    };

    /** Cells get thinner towards the inner and outer sides, where the slots end freely, unless they
     * are to be even. */
    std::vector<double> radial_lines(const unsigned int n_cells, const bool are_even)
    {
      if (are_even)
        return lines_from_edge(1., n_cells, 1.);
      std::vector<double> lines;
      for (unsigned int i = 0; i <= n_cells; ++i)
        lines.push_back(0.5 * (1. - std::cos(i * numbers::PI / n_cells)));
      return lines;
    }

    /** Sets the boundary ids while the mesh is still the box of chart coordinates (rho, s, z). */
    void set_boundary_ids(Triangulation<3> &box, const SectorForm form,
                          const StatorGeometry &stator, const Parts parts)
    {
      const double first_s = form == SectorForm::half ? 0. : -2.;
      const double top     = stator.base_thickness + stator.tooth_height;
      const auto at        = [](const double a, const double b) { return is_same_place(a, b, 1.); };
      const auto at_height = [&](const double z, const double height)
      { return is_same_place(z, height, top); };
      for (const auto &cell : box.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
          {
            const Point<3> center = face->center();
            if (at(center[1], 2.))
              face->set_boundary_id(form == SectorForm::half ? ids::cut : ids::cut_high);
            else if (at(center[1], first_s))
              face->set_boundary_id(form == SectorForm::half ? ids::mirror : ids::cut_low);
            else if (at_height(center[2], top))
              face->set_boundary_id(ids::tooth_top);
            else if (at_height(center[2], 0.) && has_skin(stator))
              face->set_boundary_id(ids::skin);
            else if (at_height(center[2], -stator.piezoceramic_thickness))
              face->set_boundary_id(ids::bottom);
            else if (at_height(center[2], stator.base_thickness) && parts == Parts::tooth)
              face->set_boundary_id(ids::clamped);
            else
              face->set_boundary_id(ids::free);
            for (unsigned int i = 0; i < 4; ++i)
              if (const auto line = face->line(i);
                  at(line->center()[0], 1.) && at_height(line->center()[2], top))
                line->set_boundary_id(ids::target_plate);
          }
    }

    /** Bonds the ceramic ring, a shell below the base, to the faces of the base marked as skin. */
    void add_piezoceramic_shell(SectorMesh &mesh, const StatorGeometry &stator,
                                const SectorManifold<2> &shape)
    {
      std::vector<Point<3>> vertices;
      std::vector<CellData<2>> cells;
      std::map<unsigned int, unsigned int> new_number;
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == ids::skin)
          {
            CellData<2> quadrilateral;
            quadrilateral.material_id = ids::piezoceramic;
            for (const unsigned int i : face->vertex_indices())
            {
              const auto [entry, is_new] =
                  new_number.emplace(face->vertex_index(i), vertices.size());
              if (is_new)
                vertices.push_back(face->vertex(i));
              quadrilateral.vertices[i] = entry->second;
            }
            cells.push_back(quadrilateral);
          }
      add_shell(mesh, vertices, cells);
      mesh.sections[ids::piezoceramic] = {stator.piezoceramic_thickness,
                                          -0.5 * stator.piezoceramic_thickness};
      mesh.shell->set_all_manifold_ids(0);
      mesh.shell->set_manifold(0, shape);
    }
  } // namespace

  namespace
  {
    /** Maps the box of chart coordinates to the body. */
    void bend_to_shape(Triangulation<3> &box, const StatorGeometry &stator,
                       const unsigned int n_teeth)
    {
      const SectorManifold<3> shape(stator, n_teeth);
      GridTools::transform([&](const Point<3> &chart) { return shape.push_forward(chart); }, box);
      box.set_all_manifold_ids(0);
      box.set_manifold(0, shape);
    }

    SectorMesh make_sector(const StatorGeometry &stator, const unsigned int n_teeth,
                           const SectorForm form, const SectorGrading &grading, const Parts parts,
                           MPI_Comm communicator)
    {
      Triangulation<2> section;
      Section(stator, n_teeth, form, grading, parts).triangulate(section);

      SectorMesh mesh;
      mesh.triangulation = empty_triangulation<3>(communicator);
      mesh.form          = form;
      mesh.n_sectors     = n_teeth;
      mesh.has_cuts      = parts == Parts::all;

      Triangulation<3> &triangulation = *mesh.triangulation;
      GridGenerator::extrude_triangulation(
          section, radial_lines(grading.n_radial, grading.even.has_value()), triangulation);
      GridTools::transform([](const Point<3> &x) { return Point<3>(x[2], x[0], x[1]); },
                           triangulation);
      set_boundary_ids(triangulation, form, stator, parts);

      bend_to_shape(triangulation, stator, n_teeth);
      return mesh;
    }
  } // namespace

  SectorMesh make_stator_sector(const StatorGeometry &stator, const unsigned int n_teeth,
                                const SectorForm form, const SectorGrading &grading,
                                MPI_Comm communicator)
  {
    SectorMesh mesh = make_sector(stator, n_teeth, form, grading, Parts::all, communicator);
    if (has_skin(stator))
      add_piezoceramic_shell(mesh, stator, SectorManifold<2>(stator, n_teeth));
    return mesh;
  }

  SectorMesh make_tooth(const StatorGeometry &stator, const unsigned int n_teeth,
                        const SectorGrading &grading, MPI_Comm communicator)
  {
    return make_sector(stator, n_teeth, SectorForm::half, grading, Parts::tooth, communicator);
  }

  namespace
  {
    /** Lines from the inner (0) to the outer side (1) of the tooth's top, finer at the outer edge
     * of the strip that the lip covers. */
    std::vector<double> lines_across(const StatorGeometry &stator, const double lip_inner,
                                     const double lip_outer, const InterfaceGrading &grading)
    {
      const double inner = std::max(lip_inner, stator.tip_inner_radius),
                   outer = std::min(lip_outer, stator.tip_outer_radius);
      std::vector<double> radii;
      for (const double distance : lines_from_edge(outer - inner, grading.n_across, grading.ratio))
        radii.insert(radii.begin(), outer - distance);
      if (inner > stator.tip_inner_radius)
      {
        const std::vector<double> distances =
            lines_from_edge(inner - stator.tip_inner_radius, 2, grading.ratio);
        for (unsigned int i = 1; i < distances.size(); ++i)
          radii.insert(radii.begin(), inner - distances[i]);
      }
      if (outer < stator.tip_outer_radius)
      {
        const std::vector<double> distances = lines_from_edge(
            stator.tip_outer_radius - outer, std::max(2u, grading.n_across), grading.ratio);
        for (unsigned int i = 1; i < distances.size(); ++i)
          radii.push_back(outer + distances[i]);
      }
      for (double &radius : radii)
        radius = (radius - stator.tip_inner_radius) /
                 (stator.tip_outer_radius - stator.tip_inner_radius);
      return radii;
    }

  } // namespace

  SectorMesh make_contact_tooth(const StatorGeometry &stator, const unsigned int n_teeth,
                                const double lip_inner, const double lip_outer,
                                const InterfaceGrading &grading, MPI_Comm communicator)
  {
    const double top              = stator.base_thickness + stator.tooth_height;
    const std::vector<double> rho = lines_across(stator, lip_inner, lip_outer, grading);
    std::vector<double> side, up;
    for (const double distance : lines_from_edge(1., grading.n_around, grading.ratio))
      side.insert(side.begin(), 1. - distance);
    for (const double distance :
         lines_from_edge(stator.tooth_height, grading.n_across + 1, grading.ratio))
      up.insert(up.begin(), top - distance);
    const std::vector<double> at_foot =
        lines_from_edge(up[1] - up[0], grading.n_at_foot, grading.ratio);
    for (unsigned int i = grading.n_at_foot - 1; i > 0; --i)
      up.insert(up.begin() + 1, up[0] + at_foot[i]);

    SectorMesh mesh;
    mesh.triangulation              = empty_triangulation<3>(communicator);
    mesh.form                       = SectorForm::half;
    mesh.n_sectors                  = n_teeth;
    mesh.has_cuts                   = false;
    Triangulation<3> &triangulation = *mesh.triangulation;
    GridGenerator::subdivided_hyper_rectangle(
        triangulation, {widths(rho), widths(side), widths(up)}, Point<3>(0., 0., up.front()),
        Point<3>(1., 1., top), false);
    const double tip = stator.tip_outer_radius - stator.tip_inner_radius;
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      cell->set_material_id(ids::tooth);
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
        {
          const Point<3> center = face->center();
          const double radius   = stator.tip_inner_radius + center[0] * tip;
          if (is_same_place(center[1], 0., 1.))
            face->set_boundary_id(ids::mirror);
          else if (is_same_place(center[2], top, top) && radius > lip_inner && radius < lip_outer)
            face->set_boundary_id(ids::tooth_top);
          else if (is_same_place(center[2], up.front(), top))
            face->set_boundary_id(ids::tooth_foot);
        }
    }
    bend_to_shape(triangulation, stator, n_teeth);
    return mesh;
  }
} // namespace ringmotor
