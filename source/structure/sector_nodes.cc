// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/sector_nodes.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ringmotor
{
  using namespace dealii;

  SectorNodes::SectorNodes(const DoFHandler<3> &dof_handler, const Mapping<3> &mapping,
                           const SectorMesh &mesh)
      : pitch(2. * numbers::PI / mesh.n_sectors)
  {
    collect(dof_handler, mapping);
    if (mesh.form == SectorForm::half)
    {
      mark(dof_handler, ids::mirror);
      mark(dof_handler, ids::cut);
      check_angle(ids::mirror, 0., "mirror plane");
      check_angle(ids::cut, numbers::PI / mesh.n_sectors, "cut");
    }
    else
    {
      mark(dof_handler, ids::cut_low);
      mark(dof_handler, ids::cut_high);
    }
    // Unit vectors of r and theta. The mirror plane needs none: there they are x and y.
    for (Node &node : nodes)
      if (node.plane != ids::free && node.plane != ids::mirror)
      {
        const double radius = std::hypot(node.position[0], node.position[1]);
        node.cosine         = node.position[0] / radius;
        node.sine           = node.position[1] / radius;
      }
  }

  void SectorNodes::collect(const DoFHandler<3> &dof_handler, const Mapping<3> &mapping)
  {
    const FiniteElement<3> &fe      = dof_handler.get_fe();
    const unsigned int n_cell_nodes = fe.base_element(0).n_dofs_per_cell();
    std::vector<Point<3>> positions(dof_handler.n_dofs());
    DoFTools::map_dofs_to_support_points(mapping, dof_handler, positions);

    place.resize(dof_handler.n_dofs());
    std::vector<bool> known(dof_handler.n_dofs(), false);
    std::vector<Dof> cell_dofs(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(cell_dofs);
      for (unsigned int cell_node = 0; cell_node < n_cell_nodes; ++cell_node)
      {
        std::array<Dof, 3> dofs;
        for (unsigned int component = 0; component < 3; ++component)
          dofs[component] = cell_dofs[fe.component_to_system_index(component, cell_node)];
        if (known[dofs[0]])
          continue;
        for (unsigned int component = 0; component < 3; ++component)
        {
          known[dofs[component]] = true;
          place[dofs[component]] = {static_cast<unsigned int>(nodes.size()), component};
        }
        nodes.push_back({dofs, positions[dofs[0]], ids::free});
      }
    }
  }

  void SectorNodes::mark(const DoFHandler<3> &dof_handler, const types::boundary_id boundary)
  {
    std::vector<Dof> face_dofs(dof_handler.get_fe().n_dofs_per_face());
    bool found = false;
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == boundary)
        {
          found = true;
          face->get_dof_indices(face_dofs);
          for (const Dof dof : face_dofs)
            nodes[place[dof].node].plane = boundary;
        }
    if (!found)
      throw UserError(
          "Stator/Mesh file: no face has the physical id " + std::to_string(boundary) +
          "; a half sector needs 11 (mirror plane) and 12 (cut), a whole sector 13 and 14 (cuts): "
          "add it to the mesh (meshes/README.md)");
  }

  void SectorNodes::check_angle(const types::boundary_id boundary, const double angle,
                                const char *what) const
  {
    for (const Node &node : nodes)
      if (node.plane == boundary)
      {
        const double found = std::atan2(node.position[1], node.position[0]);
        if (std::abs(found - angle) > 1e-6 * numbers::PI / 180. * 10.)
          throw UserError("Stator/Mesh file: a node of the " + std::string(what) +
                          " (physical id " + std::to_string(boundary) +
                          ") lies at theta = " + std::to_string(found * 180. / numbers::PI) +
                          " degrees; all must lie at " +
                          std::to_string(angle * 180. / numbers::PI) +
                          " degrees: turn the mesh or correct Motor/Number of teeth");
      }
  }

  bool SectorNodes::on(const Dof dof, const types::boundary_id boundary) const
  {
    return nodes[place[dof].node].plane == boundary;
  }

  void SectorNodes::check_turn(const Node &low, const Node &high) const
  {
    const double sine   = low.cosine * high.sine - low.sine * high.cosine;
    const double cosine = low.cosine * high.cosine + low.sine * high.sine;
    const double degree = numbers::PI / 180.;
    const double turn   = std::atan2(sine, cosine);
    if (std::abs(turn - pitch) > 1e-6)
      throw UserError("Stator/Mesh file: the high cut (physical id 14) is turned by " +
                      std::to_string(turn / degree) + " degrees against the low cut (13); " +
                      std::to_string(pitch / degree) +
                      " are wanted: correct the mesh or Motor/Number of teeth");
  }

  std::vector<std::pair<SectorNodes::Dof, SectorNodes::Dof>>
  SectorNodes::partners(const AffineConstraints<double> &hanging_nodes) const
  {
    struct OnCut
    {
      double radius, z;
      const Node *node;
    };
    const auto on_cut = [&](const types::boundary_id boundary)
    {
      std::vector<OnCut> found;
      for (const Node &node : nodes)
        if (node.plane == boundary && !hanging_nodes.is_constrained(node.dofs[0]))
          found.push_back(
              {std::hypot(node.position[0], node.position[1]), node.position[2], &node});
      std::sort(found.begin(), found.end(),
                [](const OnCut &a, const OnCut &b) { return a.radius < b.radius; });
      return found;
    };
    const std::vector<OnCut> low = on_cut(ids::cut_low), high = on_cut(ids::cut_high);
    const double tolerance = 1e-7 * (high.empty() ? 1. : high.back().radius);

    std::vector<std::pair<Dof, Dof>> pairs;
    for (const OnCut &node : high)
    {
      auto candidate =
          std::lower_bound(low.begin(), low.end(), node.radius - tolerance,
                           [](const OnCut &a, const double radius) { return a.radius < radius; });
      while (candidate != low.end() && candidate->radius <= node.radius + tolerance &&
             std::abs(candidate->z - node.z) > tolerance)
        ++candidate;
      if (candidate == low.end() || candidate->radius > node.radius + tolerance ||
          low.size() != high.size())
        throw UserError("Stator/Mesh file: the two cuts (physical ids 13 and 14) do not match: the "
                        "node at r = " +
                        std::to_string(1e3 * node.radius) +
                        " mm, z = " + std::to_string(1e3 * node.z) +
                        " mm of the high cut has no partner on the low cut; mesh one as a turned "
                        "copy of the other "
                        "(Gmsh: Periodic Surface)");
      check_turn(*candidate->node, *node.node);
      for (unsigned int component = 0; component < 3; ++component)
        pairs.emplace_back(node.node->dofs[component], candidate->node->dofs[component]);
    }
    return pairs;
  }

  AffineConstraints<double>
  SectorNodes::scalar_hanging_node_constraints(const DoFHandler<3> &dof_handler) const
  {
    AffineConstraints<double> cartesian;
    DoFTools::make_hanging_node_constraints(dof_handler, cartesian);
    cartesian.close();

    AffineConstraints<double> constraints;
    for (const auto &line : cartesian.get_lines())
      if (place[line.index].component == 0)
      {
        constraints.add_line(place[line.index].node);
        for (const auto &[dof, weight] : line.entries)
          constraints.add_entry(place[line.index].node, place[dof].node, weight);
      }
    constraints.close();
    return constraints;
  }

  AffineConstraints<double>
  SectorNodes::hanging_node_constraints(const AffineConstraints<double> &scalar) const
  {
    AffineConstraints<double> constraints;
    for (const auto &line : scalar.get_lines())
      for (unsigned int component = 0; component < 3; ++component)
      {
        const Node &slave       = nodes[line.index];
        const bool slave_on_cut = slave.plane != ids::free && slave.plane != ids::mirror;
        const Dof dof           = slave.dofs[component];
        constraints.add_line(dof);
        for (const auto &[node, weight] : line.entries)
        {
          const Node &master = nodes[node];
          if (slave_on_cut || component == 2 || master.sine == 0.)
            constraints.add_entry(dof, master.dofs[component], weight); // same axes
          else
          {
            const double along_r     = component == 0 ? master.cosine : master.sine;
            const double along_theta = component == 0 ? -master.sine : master.cosine;
            constraints.add_entry(dof, master.dofs[0], weight * along_r);
            constraints.add_entry(dof, master.dofs[1], weight * along_theta);
          }
        }
      }
    constraints.close();
    return constraints;
  }

  Tensor<1, 3> SectorNodes::direction(const Dof dof) const
  {
    const Node &node = nodes[place[dof].node];
    Tensor<1, 3> direction;
    switch (place[dof].component)
    {
    case 0:
      direction[0] = node.cosine;
      direction[1] = node.sine;
      break;
    case 1:
      direction[0] = -node.sine;
      direction[1] = node.cosine;
      break;
    default:
      direction[2] = 1.;
    }
    return direction;
  }

  void SectorNodes::rotate_to_axes(const std::vector<Dof> &cell_dofs,
                                   FullMatrix<double> &matrix) const
  {
    // Position of the y component in the cell, for the node whose x component is met.
    for (unsigned int i = 0; i < cell_dofs.size(); ++i)
    {
      const Node &node = nodes[place[cell_dofs[i]].node];
      if (node.sine == 0. || place[cell_dofs[i]].component != 0)
        continue;
      const unsigned int j =
          std::find(cell_dofs.begin(), cell_dofs.end(), node.dofs[1]) - cell_dofs.begin();
      for (unsigned int column = 0; column < matrix.n(); ++column)
      {
        const double x = matrix(i, column), y = matrix(j, column);
        matrix(i, column) = node.cosine * x + node.sine * y;
        matrix(j, column) = -node.sine * x + node.cosine * y;
      }
      for (unsigned int row = 0; row < matrix.m(); ++row)
      {
        const double x = matrix(row, i), y = matrix(row, j);
        matrix(row, i) = node.cosine * x + node.sine * y;
        matrix(row, j) = -node.sine * x + node.cosine * y;
      }
    }
  }

  void SectorNodes::rotate_to_cartesian(Vector<double> &field) const
  {
    for (const Node &node : nodes)
    {
      const double r = field[node.dofs[0]], theta = field[node.dofs[1]];
      field[node.dofs[0]] = node.cosine * r - node.sine * theta;
      field[node.dofs[1]] = node.sine * r + node.cosine * theta;
    }
  }

  void SectorNodes::interpolate(
      const std::function<std::array<std::complex<double>, 3>(const Point<3> &)> &displacement,
      Vector<double> &real, Vector<double> &imaginary) const
  {
    for (const Node &node : nodes)
    {
      const std::array<std::complex<double>, 3> u = displacement(node.position);
      const std::array<std::complex<double>, 3> along{
          {node.cosine * u[0] + node.sine * u[1], -node.sine * u[0] + node.cosine * u[1], u[2]}};
      for (unsigned int component = 0; component < 3; ++component)
      {
        real[node.dofs[component]]      = along[component].real();
        imaginary[node.dofs[component]] = along[component].imag();
      }
    }
  }
} // namespace ringmotor
