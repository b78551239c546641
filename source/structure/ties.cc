// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/structure/foot.h>
#include <ringmotor/structure/ties.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr double negligible_weight = 1e-10;

    /** The cells with a face of this boundary id. */
    template <int dim>
    std::vector<typename DoFHandler<dim, 3>::active_cell_iterator>
    cells_at(const DoFHandler<dim, 3> &dof_handler, const types::boundary_id boundary)
    {
      std::vector<typename DoFHandler<dim, 3>::active_cell_iterator> cells;
      for (const auto &cell : dof_handler.active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
          if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == boundary)
          {
            cells.push_back(cell);
            break;
          }
      return cells;
    }

    using Weights = std::map<unsigned int, double>; ///< by node

    /** The coordinate of a node that this one equals up to the errors of the search for the foot of
     * a point, in units of the cell, if there is one: matching meshes must match exactly. */
    double snapped(const double coordinate, const std::vector<Point<3>> &nodes)
    {
      for (const Point<3> &node : nodes)
        if (std::abs(node[0] - coordinate) < 1e-6)
          return node[0];
      return coordinate;
    }

    /** The weights of a cell's displacement nodes at a point, from its shape functions. */
    Weights weights_at(const Foot<3> &foot, const SectorNodes &nodes)
    {
      const FiniteElement<3> &fe = foot.cell->get_fe();
      Point<3> unit;
      for (unsigned int d = 0; d < 3; ++d)
        unit[d] = snapped(foot.unit[d], fe.base_element(0).get_unit_support_points());
      std::vector<SectorNodes::Dof> dofs(fe.n_dofs_per_cell());
      foot.cell->get_dof_indices(dofs);
      Weights weights;
      for (unsigned int i = 0; i < fe.base_element(0).n_dofs_per_cell(); ++i)
        if (const double weight = fe.base_element(0).shape_value(i, unit);
            std::abs(weight) > negligible_weight)
          weights[nodes.node(dofs[fe.component_to_system_index(0, i)])] = weight;
      return weights;
    }

    /** Averages of the solid's displacement on a line across a shell's edge, by nodes. */
    struct AcrossTheShell
    {
      Weights mean;      ///< of the displacement
      Weights parabolic; ///< mean with the weight of the shear stress, 3/2 (1 - 4 z^2/t^2)
      Weights slope;     ///< first moment over moment of inertia, 12/t^3 int z u dz
    };

    AcrossTheShell
    integrate_across(const TiedMeshes &meshes,
                     const std::vector<DoFHandler<3>::active_cell_iterator> &solid_cells,
                     const Point<3> &on_surface, const Tensor<1, 3> &normal,
                     const ShellSection &section)
    {
      // Exact for linear functions, whatever cells the line runs through.
      const QGauss<1> gauss(3);
      constexpr unsigned int n_panels = 16;
      AcrossTheShell result;
      for (unsigned int panel = 0; panel < n_panels; ++panel)
        for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          const double share = (panel + gauss.point(q)[0]) / n_panels - 0.5; // z/t
          const Point<3> x   = on_surface + (section.offset + share * section.thickness) * normal;
          const auto foot    = foot_of<3>(x, solid_cells, meshes.mapping, 1e-3 * section.thickness);
          AssertThrow(foot, ExcMessage("The edge of a shell is tied to faces that do not cover its "
                                       "thickness."));
          for (const auto &[node, value] : weights_at(*foot, meshes.nodes))
          {
            const double weight = value * gauss.weight(q) / n_panels;
            result.mean[node] += weight;
            result.parabolic[node] += weight * 1.5 * (1. - 4. * share * share);
            result.slope[node] += weight * 12. * share / section.thickness;
          }
        }
      return result;
    }

    /** The matrix of u -> n x u. */
    Tensor<2, 3> cross_with(const Tensor<1, 3> &n)
    {
      Tensor<2, 3> matrix;
      for (unsigned int d = 0; d < 3; ++d)
      {
        const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
        matrix[d][f] = n[e];
        matrix[d][e] = -n[f];
      }
      return matrix;
    }

    /** Nodes on the faces of a solid or the edges of a shell with this id. */
    template <int dim>
    std::set<unsigned int> nodes_on(const DoFHandler<dim, 3> &dof_handler, const SectorNodes &nodes,
                                    const types::boundary_id boundary,
                                    const SectorNodes::Dof first_dof)
    {
      const FiniteElement<dim, 3> &fe = dof_handler.get_fe();
      std::vector<SectorNodes::Dof> face_dofs(fe.n_dofs_per_face());
      std::set<unsigned int> found;
      for (const auto &cell : cells_at(dof_handler, boundary))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == boundary)
          {
            face->get_dof_indices(face_dofs);
            for (unsigned int i = 0; i < face_dofs.size(); ++i)
              if (fe.face_system_to_component_index(i).first == 0)
                found.insert(nodes.node(first_dof + face_dofs[i]));
          }
      return found;
    }
  } // namespace

  namespace
  {
    /** Displacement and rotation of a point of the shell's edge, as given by the solid there. */
    std::array<SlaveNode, 2> edge_slaves(const std::array<unsigned int, 2> &shell_nodes,
                                         const AcrossTheShell &across, const Tensor<1, 3> &normal,
                                         const ShellSection &section)
    {
      const Tensor<2, 3> along_normal = outer_product(normal, normal);
      const Tensor<2, 3> in_surface   = unit_symmetric_tensor<3>() - symmetrize(along_normal);
      // u(z) = mean + z slope; slope = theta x n, so theta = n x slope except for its part along n.
      SlaveNode displacement{shell_nodes[0], {}, {}}, rotation{shell_nodes[1], {}, normal};
      for (const auto &[node, mean] : across.mean)
      {
        const double slope = across.slope.at(node);
        displacement.masters.emplace_back(node, (mean - section.offset * slope) * in_surface +
                                                    across.parabolic.at(node) * along_normal);
        rotation.masters.emplace_back(node, slope * cross_with(normal));
      }
      return {{displacement, rotation}};
    }

    /** Number of distinct points of the shell's edge over which nodes of the solid lie. */
    std::size_t n_feet(const TiedMeshes &meshes)
    {
      const auto edge_cells = cells_at(meshes.shell, ids::shell_root);
      std::vector<Point<3>> feet;
      for (const unsigned int node : nodes_on(meshes.solid, meshes.nodes, ids::shell_root, 0))
      {
        const Point<3> &x = meshes.nodes.position(node);
        const auto foot   = foot_of<2>(x, edge_cells, meshes.shell_mapping, 0.5 * x.norm());
        AssertThrow(foot, ExcMessage("A face is tied to the edge of a shell that is far from it."));
        const Point<3> on_shell =
            meshes.shell_mapping.transform_unit_to_real_cell(foot->cell, foot->unit);
        // The feet were searched for: the same one is found up to the search's errors only.
        if (std::none_of(feet.begin(), feet.end(),
                         [&](const Point<3> &other)
                         { return on_shell.distance(other) < 1e-8 * x.norm(); }))
          feet.push_back(on_shell);
      }
      return feet.size();
    }
  } // namespace

  std::vector<SlaveNode> edge_ties(const TiedMeshes &meshes, const SectorMesh &mesh)
  {
    const SectorNodes &nodes = meshes.nodes;
    const std::set<unsigned int> edge =
        nodes_on(meshes.shell, nodes, ids::shell_root, nodes.first_shell_dof());
    AssertThrow(
        n_feet(meshes) <= edge.size(),
        ExcMessage("A solid is finer than the edge of the shell that is tied to it, so that "
                   "the shell would constrain it at single points: coarsen the solid or refine "
                   "the shell."));

    const auto solid_cells        = cells_at(meshes.solid, ids::shell_root);
    const FiniteElement<2, 3> &fe = meshes.shell.get_fe();
    FEValues<2, 3> at_nodes(meshes.shell_mapping, fe,
                            Quadrature<2>(fe.base_element(0).get_unit_support_points()),
                            update_quadrature_points | update_normal_vectors);
    std::vector<SectorNodes::Dof> dofs(fe.n_dofs_per_cell());
    std::set<unsigned int> done;
    std::vector<SlaveNode> slaves;
    for (const auto &cell : cells_at(meshes.shell, ids::shell_root))
    {
      at_nodes.reinit(cell);
      cell->get_dof_indices(dofs);
      for (const unsigned int i : at_nodes.quadrature_point_indices())
      {
        const auto node_of = [&](const unsigned int component) {
          return nodes.node(nodes.first_shell_dof() +
                            dofs[fe.component_to_system_index(component, i)]);
        };
        const unsigned int node = node_of(0);
        if (edge.count(node) == 0 || !done.insert(node).second)
          continue;
        const Tensor<1, 3> normal   = at_nodes.normal_vector(i);
        const ShellSection &section = mesh.sections.at(cell->material_id());
        const AcrossTheShell across =
            integrate_across(meshes, solid_cells, at_nodes.quadrature_point(i), normal, section);
        for (const SlaveNode &slave : edge_slaves({{node, node_of(3)}}, across, normal, section))
          slaves.push_back(slave);
      }
    }
    return slaves;
  }

  std::vector<SlaveNode> skin_ties(const TiedMeshes &meshes)
  {
    const SectorNodes &nodes = meshes.nodes;
    const auto solid_cells   = cells_at(meshes.solid, ids::skin);
    std::vector<SlaveNode> slaves;
    if (solid_cells.empty())
      return slaves;
    const FiniteElement<2, 3> &fe = meshes.shell.get_fe();
    std::vector<SectorNodes::Dof> dofs(fe.n_dofs_per_cell());
    std::set<unsigned int> done;
    for (const auto &cell : meshes.shell.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      unsigned int n_bonded = 0;
      for (unsigned int i = 0; i < fe.base_element(0).n_dofs_per_cell(); ++i)
      {
        const unsigned int node =
            nodes.node(nodes.first_shell_dof() + dofs[fe.component_to_system_index(0, i)]);
        const auto foot =
            foot_of<3>(nodes.position(node), solid_cells, meshes.mapping, 1e-3 * cell->diameter());
        if (!foot)
          continue;
        ++n_bonded;
        if (!done.insert(node).second)
          continue;
        SlaveNode slave{node, {}, {}};
        for (const auto &[master, weight] : weights_at(*foot, nodes))
          slave.masters.emplace_back(master, weight * unit_symmetric_tensor<3>());
        slaves.push_back(std::move(slave));
      }
      AssertThrow(n_bonded == 0 || n_bonded == fe.base_element(0).n_dofs_per_cell(),
                  ExcMessage("A cell of a shell lies on a solid only in part."));
    }
    return slaves;
  }
} // namespace ringmotor
