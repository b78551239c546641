// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/mortar.h>
#include <ringmotor/contact/ring_compliance.h>
#include <ringmotor/contact/solve/contact_solver.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/structure/surface_load.h>

#include "support/materials.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace ringmotor::tests
{
  /** Lines of a block's cells in r (m), theta (rad, from 0 on) and z (m, the face that touches
   * first, the clamped one last). */
  struct BlockLines
  {
    std::vector<double> r, theta, z;
  };

  /** A block clamped at its far end, condensed to the contact face within some radii and, if there
   * are any, to side loads. Half of it is meshed. */
  class CondensedBlock
  {
  public:
    static constexpr dealii::types::boundary_id touching = 50, side = 51;

    CondensedBlock(const BlockLines &lines, const Material &material, const unsigned int degree,
                   const double from = 0., const double to = 1e300,
                   const std::optional<Traction> &side_traction = {})
        : mesh(make(lines, from, to)), sector(mesh, all_of(material), degree),
          meshed(solid_surface(sector, touching)), whole(whole_surface(meshed, mesh.form))
    {
      std::vector<LinearForm> forms = displacement_forms(meshed);
      if (side_traction)
        forms.push_back(load_form(*side_traction));
      const Condensation condensation(sector, forms, {}, {}, 0.);
      const InterfaceCompliance of_forms(condensation); // the block has no cuts: all is at rest
      compliance           = sector_compliance(of_forms, whole.origin);
      const unsigned int n = 3 * meshed.nodes.size();
      // The side load has the symmetry of the real field.
      by_side_load.assign(3 * whole.origin.size(), 0.);
      if (side_traction)
        for (unsigned int i = 0; i < by_side_load.size(); ++i)
        {
          const MirroredNode &origin = whole.origin[i / 3];
          by_side_load[i]            = (origin.mirrored && i % 3 == 1 ? -1. : 1.) *
                            of_forms.at_rest(0)(3 * origin.node + i % 3, n);
        }
    }

    const ContactSurface &surface() const { return whole.surface; }

    SurfaceCompliance compliance;     ///< of the nodes of surface()
    std::vector<double> by_side_load; ///< their motion due to the side load (m)

  private:
    static SectorMesh make(const BlockLines &lines, const double from, const double to)
    {
      using namespace dealii;
      const bool lies_below       = lines.z.back() < lines.z.front();
      std::vector<double> heights = lines.z;
      if (lies_below)
        std::reverse(heights.begin(), heights.end());
      std::vector<std::vector<double>> steps;
      for (const std::vector<double> *line :
           std::initializer_list<const std::vector<double> *>{&lines.r, &lines.theta, &heights})
      {
        steps.emplace_back();
        for (unsigned int i = 1; i < line->size(); ++i)
          steps.back().push_back((*line)[i] - (*line)[i - 1]);
      }
      // Its angle is arbitrary: it has no cuts.
      SectorMesh mesh{empty_triangulation<3>(MPI_COMM_SELF), SectorForm::half, 1, false};
      GridGenerator::subdivided_hyper_rectangle(
          *mesh.triangulation, steps, Point<3>(lines.r.front(), lines.theta.front(), heights[0]),
          Point<3>(lines.r.back(), lines.theta.back(), heights.back()), false);
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
      {
        cell->set_material_id(ids::base);
        for (unsigned int f = 0; f < 6; ++f)
          if (cell->at_boundary(f))
          {
            const double r = cell->face(f)->center()[0];
            cell->face(f)->set_boundary_id(f == 2                   ? ids::mirror
                                           : f < 4                  ? side
                                           : (f == 4) == lies_below ? ids::clamped
                                           : r > from && r < to     ? touching
                                                                    : ids::free);
          }
      }
      GridTools::transform([](const Point<3> &x)
                           { return Point<3>(x[0] * std::cos(x[1]), x[0] * std::sin(x[1]), x[2]); },
                           *mesh.triangulation);
      mesh.triangulation->set_all_manifold_ids(0);
      mesh.triangulation->set_manifold(0, CylindricalManifold<3>(2));
      return mesh;
    }

    LinearForm load_form(const Traction &traction) const
    {
      LinearForm form;
      const dealii::Vector<double> load = sector.from_forces(face_load(sector, side, traction))[0];
      for (unsigned int dof = 0; dof < load.size(); ++dof)
        if (load[dof] != 0.)
          form.emplace_back(dof, load[dof]);
      return form;
    }

    SectorMesh mesh;
    CyclicSector sector;
    ContactSurface meshed;
    SectorSurface whole;
  };
} // namespace ringmotor::tests
