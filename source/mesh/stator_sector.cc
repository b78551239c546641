// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/sector_manifold.h>
#include <ringmotor/mesh/stator_sector.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /**
     * Widths of the cells over a length of @p total (in chart units; @p physical in m) in order
     * away from the slot root: the innermost is @p finest m wide, each further one wider by
     * 1/ratio.
     */
    std::vector<double> widths_from_root(const double total, const double physical,
                                         const double finest, const double ratio)
    {
      std::vector<double> lines{0.};
      // A last cell less than sqrt(ratio) of the one before it would only add a sliver.
      for (double distance = finest; distance < physical * std::sqrt(ratio); distance /= ratio)
        lines.push_back(distance);
      // A cell over most of the cross-section's height is too long for its bending.
      if (physical - lines.back() > 0.6 * physical)
        lines.push_back(0.5 * (lines.back() + physical));
      lines.push_back(physical);

      std::vector<double> widths;
      for (unsigned int i = 1; i < lines.size(); ++i)
        widths.push_back((lines[i] - lines[i - 1]) * total / physical);
      return widths;
    }

    std::vector<double> reversed(std::vector<double> widths)
    {
      std::reverse(widths.begin(), widths.end());
      return widths;
    }

    void append(std::vector<double> &widths, const std::vector<double> &more)
    {
      widths.insert(widths.end(), more.begin(), more.end());
    }

    /** Sets the boundary ids while the mesh is still the box of chart coordinates (rho, s, z). */
    void set_boundary_ids(Triangulation<3> &box, const SectorForm form, const double top)
    {
      const double first_s = form == SectorForm::half ? 0. : -2.;
      const auto at        = [](const double a, const double b) { return std::abs(a - b) < 1e-10; };
      for (const auto &cell : box.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
          {
            const Point<3> center = face->center();
            if (at(center[1], 2.))
              face->set_boundary_id(form == SectorForm::half ? ids::cut : ids::cut_high);
            else if (at(center[1], first_s))
              face->set_boundary_id(form == SectorForm::half ? ids::mirror : ids::cut_low);
            else if (std::abs(center[2] - top) < 1e-10 * top)
              face->set_boundary_id(ids::tooth_top);
            else
              face->set_boundary_id(ids::free);
          }
    }
  } // namespace

  SectorMesh make_stator_sector(const StatorGeometry &stator, const unsigned int n_teeth,
                                const SectorForm form, const SectorGrading &grading,
                                MPI_Comm communicator)
  {
    const double half_slot  = 0.5 * stator.slot_width;
    const double half_tooth = numbers::PI * stator.base_inner_radius / n_teeth - half_slot;
    const double finest     = half_slot * std::pow(grading.ratio, grading.n_layers);
    const auto from_root    = [&](const double total, const double physical)
    { return widths_from_root(total, physical, finest, grading.ratio); };

    const std::vector<double> tooth_widths = from_root(1., half_tooth);
    const std::vector<double> slot_widths  = from_root(1., half_slot);
    std::vector<double> s_widths;
    if (form == SectorForm::whole)
    {
      append(s_widths, reversed(slot_widths));
      append(s_widths, tooth_widths);
    }
    append(s_widths, reversed(tooth_widths));
    append(s_widths, slot_widths);

    const bool with_ring = stator.piezoceramic_thickness > 0.;
    std::vector<double> z_widths;
    if (with_ring)
      z_widths.push_back(stator.piezoceramic_thickness);
    append(z_widths, reversed(from_root(stator.base_thickness, stator.base_thickness)));
    const unsigned int n_below_slot = z_widths.size();
    append(z_widths, from_root(stator.tooth_height, stator.tooth_height));

    // Towards the inner and outer side, where the slots' pattern ends freely, cells get thinner.
    std::vector<double> rho_widths;
    for (unsigned int i = 0; i < grading.n_radial; ++i)
      rho_widths.push_back(0.5 * (std::cos(i * numbers::PI / grading.n_radial) -
                                  std::cos((i + 1) * numbers::PI / grading.n_radial)));

    // Cells without a material are left out by the generator: the slots.
    Table<3, types::material_id> materials(rho_widths.size(), s_widths.size(), z_widths.size());
    const unsigned int n_slot      = slot_widths.size();
    const unsigned int first_tooth = form == SectorForm::whole ? n_slot : 0;
    for (unsigned int i = 0; i < rho_widths.size(); ++i)
      for (unsigned int j = 0; j < s_widths.size(); ++j)
        for (unsigned int k = 0; k < z_widths.size(); ++k)
        {
          const bool under_tooth = j >= first_tooth && j + n_slot < s_widths.size();
          materials(i, j, k)     = with_ring && k == 0 ? ids::piezoceramic
                                   : k < n_below_slot  ? ids::base
                                   : under_tooth       ? ids::tooth
                                                       : numbers::invalid_material_id;
        }

    SectorMesh mesh{empty_triangulation(communicator), form, n_teeth};
    Triangulation<3> &triangulation = *mesh.triangulation;
    const double first_s            = form == SectorForm::half ? 0. : -2.;
    GridGenerator::subdivided_hyper_rectangle(triangulation, {rho_widths, s_widths, z_widths},
                                              Point<3>(0., first_s, -stator.piezoceramic_thickness),
                                              materials);
    set_boundary_ids(triangulation, form, stator.base_thickness + stator.tooth_height);

    const SectorManifold shape(stator, n_teeth);
    GridTools::transform([&](const Point<3> &chart) { return shape.push_forward(chart); },
                         triangulation);
    triangulation.set_all_manifold_ids(0);
    triangulation.set_manifold(0, shape);
    return mesh;
  }
} // namespace ringmotor
