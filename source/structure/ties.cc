// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/structure/ties.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/fe.h>

#include <algorithm>
#include <optional>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr double negligible_weight = 1e-10;

    /** A point of a mesh in the coordinates of one of its cells. */
    template <int dim>
    struct Foot
    {
      typename DoFHandler<dim, 3>::active_cell_iterator cell;
      Point<dim> unit;
      double distance; ///< m
    };

    /** The point nearest to @p x in these cells, if they come so near as @p reach. */
    template <int dim>
    std::optional<Foot<dim>>
    foot_of(const Point<3> &x,
            const std::vector<typename DoFHandler<dim, 3>::active_cell_iterator> &cells,
            const Mapping<dim, 3> &mapping, const double reach)
    {
      std::optional<Foot<dim>> best;
      for (const auto &cell : cells)
        if (cell->center().distance(x) < cell->diameter() + reach)
          try
          {
            const Point<dim> unit = GeometryInfo<dim>::project_to_unit_cell(
                mapping.transform_real_to_unit_cell(cell, x));
            const double distance = mapping.transform_unit_to_real_cell(cell, unit).distance(x);
            if (distance < (best ? best->distance : reach))
              best = Foot<dim>{cell, unit, distance};
          }
          catch (const typename Mapping<dim, 3>::ExcTransformationFailed &)
          {
            // far from this cell
          }
      return best;
    }

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

    /** The nodes of displacement that a cell's shape functions give weight at a point, or, from
     * @p first_component 3, those of rotation. */
    template <int dim>
    std::vector<std::pair<unsigned int, double>>
    weights_at(const Foot<dim> &foot, const SectorNodes &nodes, const SectorNodes::Dof first_dof,
               const unsigned int first_component = 0)
    {
      const FiniteElement<dim, 3> &fe = foot.cell->get_fe();
      std::vector<SectorNodes::Dof> dofs(fe.n_dofs_per_cell());
      foot.cell->get_dof_indices(dofs);
      std::vector<std::pair<unsigned int, double>> weights;
      for (unsigned int i = 0; i < fe.base_element(0).n_dofs_per_cell(); ++i)
        if (const double weight = fe.base_element(0).shape_value(i, foot.unit);
            std::abs(weight) > negligible_weight)
          weights.emplace_back(
              nodes.node(first_dof + dofs[fe.component_to_system_index(first_component, i)]),
              weight);
      return weights;
    }

    /** The matrix of theta -> theta x d. */
    Tensor<2, 3> turn_by(const Tensor<1, 3> &d)
    {
      Tensor<2, 3> matrix;
      matrix[0][1] = d[2];
      matrix[1][0] = -d[2];
      matrix[1][2] = d[0];
      matrix[2][1] = -d[0];
      matrix[2][0] = d[1];
      matrix[0][2] = -d[1];
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

  std::vector<SlaveNode> edge_ties(const TiedMeshes &meshes)
  {
    const SectorNodes &nodes = meshes.nodes;
    const auto edge_cells    = cells_at(meshes.shell, ids::shell_root);
    std::vector<Point<3>> feet;
    std::vector<SlaveNode> slaves;
    for (const unsigned int node : nodes_on(meshes.solid, nodes, ids::shell_root, 0))
    {
      const Point<3> &x = nodes.position(node);
      const auto foot   = foot_of<2>(x, edge_cells, meshes.shell_mapping, 0.5 * x.norm());
      AssertThrow(foot, ExcMessage("A face is tied to the edge of a shell that is far from it."));
      const Point<3> on_shell =
          meshes.shell_mapping.transform_unit_to_real_cell(foot->cell, foot->unit);
      const Tensor<1, 3> way = x - on_shell;
      if (std::none_of(feet.begin(), feet.end(),
                       [&](const Point<3> &other)
                       { return on_shell.distance(other) < 1e-8 * x.norm(); }))
        feet.push_back(on_shell);
      SlaveNode slave{node, {}};
      for (const auto &[master, weight] : weights_at(*foot, nodes, nodes.first_shell_dof()))
        slave.masters.emplace_back(master, weight * unit_symmetric_tensor<3>());
      if (way.norm() > 1e-10 * x.norm())
        for (const auto &[master, weight] : weights_at(*foot, nodes, nodes.first_shell_dof(), 3))
          slave.masters.emplace_back(master, weight * turn_by(way));
      slaves.push_back(std::move(slave));
    }

    AssertThrow(
        nodes_on(meshes.shell, nodes, ids::shell_root, nodes.first_shell_dof()).size() <=
            feet.size(),
        ExcMessage("The edge of a shell is finer than the solid that is tied to it, so that the "
                   "solid does not hold all of its nodes: refine the solid or coarsen the shell."));
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
        SlaveNode slave{node, {}};
        for (const auto &[master, weight] : weights_at(*foot, nodes, 0))
          slave.masters.emplace_back(master, weight * unit_symmetric_tensor<3>());
        slaves.push_back(std::move(slave));
      }
      AssertThrow(n_bonded == 0 || n_bonded == fe.base_element(0).n_dofs_per_cell(),
                  ExcMessage("A cell of a shell lies on a solid only in part."));
    }
    return slaves;
  }
} // namespace ringmotor
