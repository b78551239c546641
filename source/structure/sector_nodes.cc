// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/sector_nodes.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ringmotor
{
  using namespace dealii;

  SectorNodes::SectorNodes(const DoFHandler<3> &solid, const Mapping<3> &mapping,
                           const DoFHandler<2, 3> &shell, const Mapping<2, 3> &shell_mapping,
                           const PotentialDofs &potentials, const SectorMesh &mesh)
      : pitch(2. * numbers::PI / mesh.n_sectors)
  {
    if (solid.has_active_dofs())
      collect(solid, mapping, 0);
    n_solid_dofs = place.size();
    if (shell.has_active_dofs())
      collect(shell, shell_mapping, n_solid_dofs);
    n_mechanical_dofs = place.size();
    if (potentials.size() > 0)
      collect(potentials, mesh, mapping);

    const bool half = mesh.form == SectorForm::half;
    std::vector<types::boundary_id> planes;
    if (half)
      planes.push_back(ids::mirror);
    if (mesh.has_cuts && half)
      planes.push_back(ids::cut);
    else if (mesh.has_cuts)
    {
      planes.push_back(ids::cut_low);
      planes.push_back(ids::cut_high);
    }
    for (const types::boundary_id plane : planes)
    {
      const bool on_solid = solid.has_active_dofs() && mark(solid, plane, 0);
      const bool on_shell = shell.has_active_dofs() && mark(shell, plane, n_solid_dofs);
      if (potentials.size() > 0)
        mark(potentials, mesh, plane);
      if (!on_solid && !on_shell)
        throw UserError(
            "Stator/Mesh file: no face has the physical id " + std::to_string(plane) +
            "; a half sector needs 11 (mirror plane) and 12 (cut), a whole sector 13 and 14 "
            "(cuts): add it to the mesh (meshes/README.md)");
    }
    if (half)
    {
      check_angle(ids::mirror, 0., "mirror plane");
      check_angle(ids::cut, numbers::PI / mesh.n_sectors, "cut");
    }
    // Unit vectors of r and theta. Not needed on the mirror plane, where they are x and y.
    for (Node &node : nodes)
      if (node.plane != ids::free && node.plane != ids::mirror)
      {
        const double radius = std::hypot(node.position[0], node.position[1]);
        node.cosine         = node.position[0] / radius;
        node.sine           = node.position[1] / radius;
      }
  }

  template <int dim>
  void SectorNodes::collect(const DoFHandler<dim, 3> &dof_handler, const Mapping<dim, 3> &mapping,
                            const Dof first_dof)
  {
    const FiniteElement<dim, 3> &fe = dof_handler.get_fe();
    const unsigned int n_cell_nodes = fe.base_element(0).n_dofs_per_cell();
    std::vector<Point<3>> positions(dof_handler.n_dofs());
    DoFTools::map_dofs_to_support_points(mapping, dof_handler, positions);

    place.resize(first_dof + dof_handler.n_dofs());
    std::vector<bool> known(dof_handler.n_dofs(), false);
    std::vector<Dof> cell_dofs(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(cell_dofs);
      for (unsigned int cell_node = 0; cell_node < n_cell_nodes; ++cell_node)
        for (unsigned int first = 0; first < fe.n_components(); first += 3)
        {
          std::array<Dof, 3> dofs;
          for (unsigned int component = 0; component < 3; ++component)
            dofs[component] = cell_dofs[fe.component_to_system_index(first + component, cell_node)];
          if (known[dofs[0]])
            continue;
          const Point<3> position = positions[dofs[0]];
          for (unsigned int component = 0; component < 3; ++component)
          {
            known[dofs[component]] = true;
            dofs[component] += first_dof;
            place[dofs[component]] = {static_cast<unsigned int>(nodes.size()), component};
          }
          nodes.push_back(
              {dofs, position, ids::free, first == 3 ? Kind::rotation : Kind::displacement});
        }
    }
  }

  template <int dim>
  bool SectorNodes::mark(const DoFHandler<dim, 3> &dof_handler, const types::boundary_id boundary,
                         const Dof first_dof)
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
            nodes[place[first_dof + dof].node].plane = boundary;
        }
    return found;
  }

  void SectorNodes::collect(const PotentialDofs &potentials, const SectorMesh &mesh,
                            const Mapping<3> &mapping)
  {
    place.resize(n_mechanical_dofs + potentials.size());
    std::vector<bool> known(potentials.size(), false);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      if (potentials.are_on(cell))
      {
        const std::vector<Dof> dofs = potentials.of(cell);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (!known[dofs[i]])
          {
            known[dofs[i]] = true;
            const Dof dof  = n_mechanical_dofs + dofs[i];
            place[dof]     = {static_cast<unsigned int>(nodes.size()), 0};
            nodes.push_back({{{dof, numbers::invalid_dof_index, numbers::invalid_dof_index}},
                             mapping.transform_unit_to_real_cell(cell, potentials.unit_point(i)),
                             ids::free,
                             Kind::potential});
          }
      }
  }

  void SectorNodes::mark(const PotentialDofs &potentials, const SectorMesh &mesh,
                         const types::boundary_id boundary)
  {
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      if (potentials.are_on(cell))
        for (const unsigned int face : cell->face_indices())
          if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == boundary)
            for (const Dof dof : potentials.on_face(cell, face))
              nodes[place[n_mechanical_dofs + dof].node].plane = boundary;
  }

  void SectorNodes::check_angle(const types::boundary_id boundary, const double angle,
                                const char *what) const
  {
    for (const Node &node : nodes)
      if (node.plane == boundary)
      {
        const double found = std::atan2(node.position[1], node.position[0]);
        if (!is_same_place(found, angle, 1.))
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
    if (!is_same_place(turn, pitch, 1.))
      throw UserError("Stator/Mesh file: the high cut (physical id 14) is turned by " +
                      std::to_string(turn / degree) + " degrees against the low cut (13); " +
                      std::to_string(pitch / degree) +
                      " are required: correct the mesh or Motor/Number of teeth");
  }

  std::vector<std::pair<SectorNodes::Dof, SectorNodes::Dof>>
  SectorNodes::partners(const AffineConstraints<double> &dependent) const
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
        if (node.plane == boundary &&
            !std::all_of(node.dofs.begin(), node.dofs.begin() + node.n_dofs(),
                         [&](const Dof dof) { return dependent.is_constrained(dof); }))
          found.push_back(
              {std::hypot(node.position[0], node.position[1]), node.position[2], &node});
      std::sort(found.begin(), found.end(),
                [](const OnCut &a, const OnCut &b) { return a.radius < b.radius; });
      return found;
    };
    const std::vector<OnCut> low = on_cut(ids::cut_low), high = on_cut(ids::cut_high);
    const double tolerance = places::rounding * (high.empty() ? 1. : high.back().radius);

    std::vector<std::pair<Dof, Dof>> pairs;
    for (const OnCut &node : high)
    {
      auto candidate =
          std::lower_bound(low.begin(), low.end(), node.radius - tolerance,
                           [](const OnCut &a, const double radius) { return a.radius < radius; });
      while (
          candidate != low.end() && candidate->radius <= node.radius + tolerance &&
          (std::abs(candidate->z - node.z) > tolerance || candidate->node->kind != node.node->kind))
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
      for (unsigned int component = 0; component < node.node->n_dofs(); ++component)
        if (!dependent.is_constrained(node.node->dofs[component]))
          pairs.emplace_back(node.node->dofs[component], candidate->node->dofs[component]);
    }
    return pairs;
  }

  Tensor<1, 3> SectorNodes::direction(const Dof dof) const
  {
    const Node &node = nodes[place[dof].node];
    Tensor<1, 3> direction;
    if (node.kind == Kind::potential)
      return direction;
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
    // Position of the y component in the cell, for the node of each x component.
    for (unsigned int i = 0; i < cell_dofs.size(); ++i)
    {
      const Node &node = nodes[place[cell_dofs[i]].node];
      if (!node.is_turned() || place[cell_dofs[i]].component != 0)
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

  void SectorNodes::rotate_to_axes(Vector<double> &field) const
  {
    for (const Node &node : nodes)
    {
      if (!node.is_turned())
        continue;
      const double x = field[node.dofs[0]], y = field[node.dofs[1]];
      field[node.dofs[0]] = node.cosine * x + node.sine * y;
      field[node.dofs[1]] = -node.sine * x + node.cosine * y;
    }
  }

  void SectorNodes::rotate_to_cartesian(Vector<double> &field) const
  {
    for (const Node &node : nodes)
    {
      if (!node.is_turned())
        continue;
      const double r = field[node.dofs[0]], theta = field[node.dofs[1]];
      field[node.dofs[0]] = node.cosine * r - node.sine * theta;
      field[node.dofs[1]] = node.sine * r + node.cosine * theta;
    }
  }

  void SectorNodes::interpolate(const std::function<NodeMotion(const Point<3> &)> &motion,
                                Vector<double> &real, Vector<double> &imaginary) const
  {
    for (const Node &node : nodes)
    {
      if (node.kind == Kind::potential)
        continue;
      const NodeMotion there = motion(node.position);
      const std::array<std::complex<double>, 3> u =
          node.kind == Kind::rotation ? there.rotation : there.displacement;
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
