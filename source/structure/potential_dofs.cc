// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/no_index.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/potential_dofs.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ringmotor
{
  using namespace dealii;

  void PotentialDofs::reinit(const Triangulation<3> &triangulation, const MaterialTable &materials,
                             const unsigned int degree)
  {
    for (const auto &[id, material] : materials)
      if (material.law)
      {
        is_piezoelectric.resize(std::max<std::size_t>(is_piezoelectric.size(), id + 1u), false);
        is_piezoelectric[id] = true;
      }
    bool has_any = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      has_any = has_any || are_on(cell);
    if (!has_any)
      return;
    dof_handler.reinit(triangulation);
    dof_handler.distribute_dofs(FE_Q<3>(degree));
    number.assign(dof_handler.n_dofs(), none);
    unsigned int next = 0;
    std::vector<Dof> dofs(dof_handler.get_fe().n_dofs_per_cell());
    for_each_cell(
        [&](const auto &cell)
        {
          cell->get_dof_indices(dofs);
          for (const Dof dof : dofs)
            if (number[dof] == none)
              number[dof] = next++;
        });
    places.assign(next, Place::inside);
    find_electrodes();
  }

  template <typename Visit>
  void PotentialDofs::for_each_cell(const Visit &visit) const
  {
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (are_on(cell))
        visit(cell);
  }

  bool PotentialDofs::are_on(const Cell &cell) const
  {
    return cell->material_id() < is_piezoelectric.size() && is_piezoelectric[cell->material_id()];
  }

  namespace
  {
    template <typename Face>
    bool lies_at(const Face &face, const double height, const double thickness)
    {
      const auto vertices = face->vertex_indices();
      return std::all_of(vertices.begin(), vertices.end(),
                         [&](const unsigned int i)
                         { return is_same_place(face->vertex(i)[2], height, thickness); });
    }

    template <typename Face>
    bool looks_along_z(const Face &face)
    {
      const Tensor<1, 3> normal =
          cross_product_3d(face->vertex(3) - face->vertex(0), face->vertex(2) - face->vertex(1));
      return std::abs(normal[2]) > 0.5 * normal.norm();
    }
  } // namespace

  void PotentialDofs::find_electrodes()
  {
    double low = std::numeric_limits<double>::max(), high = -low;
    for_each_cell(
        [&](const auto &cell)
        {
          for (const unsigned int vertex : cell->vertex_indices())
          {
            low  = std::min(low, cell->vertex(vertex)[2]);
            high = std::max(high, cell->vertex(vertex)[2]);
          }
        });
    const std::string needed = "; with Effects/Piezoelectric coupling it must be a flat layer "
                               "between two electrodes: change the mesh, or set the effect to off";
    std::array<bool, 2> found{};
    for_each_cell(
        [&](const auto &cell)
        {
          for (const unsigned int number : cell->face_indices())
          {
            const auto &face   = cell->face(number);
            const bool is_low  = lies_at(face, low, high - low),
                       is_high = lies_at(face, high, high - low);
            if (is_low || is_high)
              for (const Dof dof : on_face(cell, number))
                places[dof] = is_high ? Place::upper_electrode : Place::lower_electrode;
            else if (cell->at_boundary(number) && looks_along_z(face))
              throw UserError("Stator: the piezoceramic has a face at z = " +
                              std::to_string(1e3 * face->center()[2]) +
                              " mm, outside of its highest and lowest plane" + needed);
            found[0] = found[0] || is_low;
            found[1] = found[1] || is_high;
          }
        });
    if (!found[0] || !found[1])
      throw UserError("Stator: the piezoceramic has no face in its " +
                      std::string(found[0] ? "highest" : "lowest") + " plane" + needed);
  }

  DoFHandler<3>::active_cell_iterator PotentialDofs::with_dofs(const Cell &cell) const
  {
    return {&dof_handler.get_triangulation(), cell->level(), cell->index(), &dof_handler};
  }

  std::vector<PotentialDofs::Dof> PotentialDofs::of(const Cell &cell) const
  {
    std::vector<Dof> dofs(dof_handler.get_fe().n_dofs_per_cell());
    with_dofs(cell)->get_dof_indices(dofs);
    for (Dof &dof : dofs)
      dof = number[dof];
    return dofs;
  }

  std::vector<PotentialDofs::Dof> PotentialDofs::on_face(const Cell &cell,
                                                         const unsigned int face) const
  {
    std::vector<Dof> dofs(dof_handler.get_fe().n_dofs_per_face());
    with_dofs(cell)->face(face)->get_dof_indices(dofs);
    for (Dof &dof : dofs)
      dof = number[dof];
    return dofs;
  }

  AffineConstraints<double> PotentialDofs::hanging_nodes() const
  {
    AffineConstraints<double> of_mesh, constraints;
    if (size() > 0)
      DoFTools::make_hanging_node_constraints(dof_handler, of_mesh);
    of_mesh.close();
    for (const auto &line : of_mesh.get_lines())
      if (const unsigned int slave = number[line.index];
          slave != none && places[slave] == Place::inside)
      {
        constraints.add_line(slave);
        for (const auto &[dof, weight] : line.entries)
        {
          Assert(number[dof] != none, ExcInternalError());
          constraints.add_entry(slave, number[dof], weight);
        }
      }
    constraints.close();
    return constraints;
  }

  std::vector<PotentialDofs::Dof> PotentialDofs::owned() const
  {
    std::vector<Dof> owned;
    if (size() > 0)
      for (const Dof dof : dof_handler.locally_owned_dofs())
        if (number[dof] != none)
          owned.push_back(number[dof]);
    return owned;
  }
} // namespace ringmotor
