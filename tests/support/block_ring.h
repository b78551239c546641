// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "support/materials.h"

#include <ringmotor/contact/ring_compliance.h>
#include <ringmotor/structure/cyclic_factors.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>

// A small ring of blocks whose lower faces can touch: as one mesh, and from one sector.

namespace ringmotor::tests::block_ring
{
  constexpr unsigned int n_sectors = 6;
  constexpr double pitch           = 2. * dealii::numbers::PI / n_sectors;
  constexpr double base = -1e-3, clamp = 4e-3; ///< m, heights of lower face and of clamped faces

  /** A ring with a block on each sector: cells of these widths in theta, in parts of the pitch,
   * from an angle on. */
  inline void make_blocks(dealii::Triangulation<3> &triangulation, std::vector<double> around,
                          const double from)
  {
    for (double &part : around)
      part *= pitch;
    const std::vector<double> radial{3e-3, 2e-3}, axial{2e-3, 3e-3};
    dealii::Table<3, dealii::types::material_id> materials(2, around.size(), 2);
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < around.size(); ++j)
      {
        materials(i, j, 0) = ids::base;
        materials(i, j, 1) =
            around[j] > 0.25 * pitch ? ids::tooth : dealii::numbers::invalid_material_id;
      }
    dealii::GridGenerator::subdivided_hyper_rectangle(
        triangulation, {radial, around, axial}, dealii::Point<3>(30e-3, from, base), materials);
    dealii::GridTools::transform(
        [](const dealii::Point<3> &x)
        { return dealii::Point<3>(x[0] * std::cos(x[1]), x[0] * std::sin(x[1]), x[2]); },
        triangulation);
  }

  /** The lower face can touch, the blocks are clamped. */
  inline void complete(SectorMesh &mesh)
  {
    const bool is_half = mesh.form == SectorForm::half;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
        {
          const dealii::Point<3> x = face->center();
          const auto at = [](const double a, const double b) { return std::abs(a - b) < 1e-9; };
          // The middle of a straight-sided face on a cut has the angle of the cut.
          const double theta = mesh.has_cuts ? std::atan2(x[1], x[0]) : 0.1 * pitch;
          face->set_boundary_id(at(x[2], base)            ? ids::lip
                                : at(x[2], clamp)         ? ids::clamped
                                : at(theta, 0.)           ? ids::mirror
                                : at(theta, 0.5 * pitch)  ? (is_half ? ids::cut : ids::cut_high)
                                : at(theta, -0.5 * pitch) ? ids::cut_low
                                                          : ids::free);
        }
    mesh.triangulation->set_all_manifold_ids(0);
    mesh.triangulation->set_manifold(0, dealii::CylindricalManifold<3>(2));
  }

  inline SectorMesh block_sector(const SectorForm form)
  {
    SectorMesh mesh{empty_triangulation<3>(MPI_COMM_SELF), form, n_sectors};
    if (form == SectorForm::half)
      make_blocks(*mesh.triangulation, {0.3, 0.2}, 0.);
    else
      make_blocks(*mesh.triangulation, {0.2, 0.3, 0.3, 0.2}, -0.5 * pitch);
    complete(mesh);
    return mesh;
  }

  inline SectorMesh block_ring()
  {
    SectorMesh mesh{empty_triangulation<3>(MPI_COMM_SELF), SectorForm::whole, 1, false};
    std::vector<dealii::Triangulation<3>> sectors(n_sectors);
    std::vector<const dealii::Triangulation<3> *> parts;
    for (unsigned int j = 0; j < n_sectors; ++j)
    {
      make_blocks(sectors[j], {0.2, 0.3, 0.3, 0.2}, (j - 0.5) * pitch);
      parts.push_back(&sectors[j]);
    }
    dealii::GridGenerator::merge_triangulations(parts, *mesh.triangulation, 1e-9);
    complete(mesh);
    return mesh;
  }

  /** Forces or motions by sector, three per node. */
  using ByComponent = std::vector<std::vector<double>>;

  /** The whole ring, without any use of its symmetry. */
  class DirectRing
  {
  public:
    DirectRing() : mesh(block_ring()), sector(mesh, all_of(steel), 2), factors(sector)
    {
      factors.factorise(0, 0.);
    }

    /** Motions of nodes at these positions (of sector 0) under forces on them. */
    ByComponent motion(const std::vector<SurfaceNode> &nodes, const ByComponent &forces)
    {
      SectorMotion loads = sector.at_rest();
      for_each(nodes,
               [&](const unsigned int j, const unsigned int i,
                   const std::array<SectorNodes::Dof, 3> &dofs, const double c, const double s)
               {
                 const double *f = forces[j].data() + 3 * i;
                 loads.solid.real[dofs[0]] += f[2] * c + f[1] * s;
                 loads.solid.real[dofs[1]] += f[2] * s - f[1] * c;
                 loads.solid.real[dofs[2]] += f[0];
               });
      std::vector<double> unknowns = sector.loads_of(0, loads);
      factors.solve(unknowns);
      const dealii::Vector<double> u = sector.expand(0, unknowns).solid.real;
      ByComponent motions(n_sectors, std::vector<double>(3 * nodes.size()));
      for_each(nodes,
               [&](const unsigned int j, const unsigned int i,
                   const std::array<SectorNodes::Dof, 3> &dofs, const double c, const double s)
               {
                 motions[j][3 * i]     = u[dofs[2]];
                 motions[j][3 * i + 1] = u[dofs[0]] * s - u[dofs[1]] * c;
                 motions[j][3 * i + 2] = u[dofs[0]] * c + u[dofs[1]] * s;
               });
      return motions;
    }

  private:
    template <typename Visit>
    void for_each(const std::vector<SurfaceNode> &nodes, const Visit &visit) const
    {
      for (unsigned int j = 0; j < n_sectors; ++j)
        for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          const double theta = nodes[i].place[1] + j * pitch;
          const double c = std::cos(theta), s = std::sin(theta);
          const dealii::Point<3> x(nodes[i].place[0] * c, nodes[i].place[0] * s, base);
          unsigned int node = 0;
          while (sector.nodes().position(node).distance(x) > 1e-9)
            ++node;
          visit(j, i,
                {{sector.nodes().dof(node, 0), sector.nodes().dof(node, 1),
                  sector.nodes().dof(node, 2)}},
                c, s);
        }
    }

    SectorMesh mesh;
    CyclicSector sector;
    CyclicFactors factors;
  };

  /** Condensed, from one sector. */
  struct BlockSector
  {
    SectorMesh mesh;
    CyclicSector sector;
    ContactSurface meshed;
    SectorSurface surface;
    Condensation condensation;
    InterfaceCompliance interface;

    explicit BlockSector(const SectorForm form)
        : mesh(block_sector(form)), sector(mesh, all_of(steel), 2),
          meshed(solid_surface(sector, ids::lip)), surface(whole_surface(meshed, form)),
          condensation(sector, displacement_forms(meshed), {}, {}, 0.), interface(condensation)
    {
    }

    RingCompliance ring(const MortarCoupling &coupling) const
    {
      return RingCompliance(n_sectors, sector_compliance(interface, surface.origin), coupling,
                            [&](const unsigned int k) { return interface.through_cut(k, {}); });
    }
  };
} // namespace ringmotor::tests::block_ring
