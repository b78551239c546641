// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/structure/sector_elements.h>
#include <ringmotor/structure/ties.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  SectorMotion &SectorMotion::operator*=(const std::complex<double> factor)
  {
    for (ComplexField *field : parts())
    {
      const Vector<double> old_real = field->real;
      field->real.equ(factor.real(), old_real);
      field->real.add(-factor.imag(), field->imaginary);
      field->imaginary *= factor.real();
      field->imaginary.add(factor.imag(), old_real);
    }
    return *this;
  }

  SectorElements::SectorElements(const SectorMesh &mesh, const MaterialTable &materials,
                                 const unsigned int degree, const LowerElectrode lower_electrode)
      : mesh(mesh), materials(materials), mapping(2), fe(FE_Q<3>(degree), 3), shell_mapping(2),
        shell_fe(FE_Q<2, 3>(degree), 6)
  {
    if (mesh.triangulation->n_levels() > 0)
    {
      dof_handler.reinit(*mesh.triangulation);
      dof_handler.distribute_dofs(fe);
      potentials.reinit(*mesh.triangulation, materials, degree);
    }
    if (mesh.shell)
    {
      shell_dof_handler.reinit(*mesh.shell);
      shell_dof_handler.distribute_dofs(shell_fe);
    }
    sector_nodes =
        SectorNodes(dof_handler, mapping, shell_dof_handler, shell_mapping, potentials, mesh);
    constrain(lower_electrode);
  }

  void SectorElements::constrain(const LowerElectrode lower_electrode)
  {
    hanging = sector_nodes.scalar_hanging_node_constraints(dof_handler, potentials);
    std::vector<SlaveNode> slaves = SectorNodes::slaves_of(hanging);
    tied.assign(sector_nodes.size(), false);
    if (dof_handler.has_active_dofs() && shell_dof_handler.has_active_dofs())
    {
      const TiedMeshes meshes{dof_handler, mapping, shell_dof_handler, shell_mapping, sector_nodes};
      for (const std::vector<SlaveNode> &ties : {edge_ties(meshes, mesh), skin_ties(meshes)})
        for (const SlaveNode &slave : ties)
        {
          tied[slave.node] = true;
          slaves.push_back(slave);
        }
    }
    if (dof_handler.has_active_dofs())
      for (const Dof dof :
           DoFTools::extract_boundary_dofs(dof_handler, ComponentMask(), {ids::clamped}))
        if (sector_nodes.component(dof) == 0)
          slaves.push_back({sector_nodes.node(dof), {}, {}});
    for (Dof i = 0; i < potentials.size(); ++i)
      if (const PotentialDofs::Place place = potentials.place(i);
          place == PotentialDofs::Place::upper_electrode ||
          (place == PotentialDofs::Place::lower_electrode &&
           lower_electrode == LowerElectrode::grounded))
        slaves.push_back({sector_nodes.node(sector_nodes.first_potential_dof() + i), {}, {}});
    dependent_dofs = sector_nodes.constraints(slaves);
  }

  IndexSet SectorElements::owned_dofs() const
  {
    IndexSet owned(n_dofs());
    if (dof_handler.has_active_dofs())
      owned.add_indices(dof_handler.locally_owned_dofs());
    if (shell_dof_handler.has_active_dofs())
      owned.add_indices(shell_dof_handler.locally_owned_dofs(), sector_nodes.first_shell_dof());
    for (const Dof dof : potentials.owned())
      owned.add_index(sector_nodes.first_potential_dof() + dof);
    return owned;
  }

  bool SectorElements::are_tied(const std::vector<Dof> &dofs) const
  {
    return std::any_of(dofs.begin(), dofs.end(),
                       [&](const Dof dof) { return tied[sector_nodes.node(dof)]; });
  }

  std::vector<SectorElements::Dof> SectorElements::dofs_of(const Cell &cell) const
  {
    std::vector<Dof> dofs(fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    return dofs;
  }

  std::vector<SectorElements::Dof> SectorElements::dofs_of(const ShellCell &cell) const
  {
    std::vector<Dof> dofs(shell_fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    for (Dof &dof : dofs)
      dof += sector_nodes.first_shell_dof();
    return dofs;
  }

  std::vector<SectorElements::Dof> SectorElements::potential_dofs_of(const Cell &cell) const
  {
    std::vector<Dof> dofs = potentials.of(cell);
    for (Dof &dof : dofs)
      dof += sector_nodes.first_potential_dof();
    return dofs;
  }

  std::vector<SectorElements::Dof> SectorElements::electrode_dofs() const
  {
    std::vector<Dof> dofs;
    for (Dof i = 0; i < potentials.size(); ++i)
      if (potentials.place(i) == PotentialDofs::Place::lower_electrode)
        dofs.push_back(sector_nodes.first_potential_dof() + i);
    return dofs;
  }

  std::vector<SectorElements::Dof> SectorElements::dofs_on(const Cell &cell,
                                                           const BarElement &bar) const
  {
    const std::vector<Dof> cell_dofs = dofs_of(cell);
    std::vector<Dof> dofs;
    for (const unsigned int i : bar.local_dofs())
      dofs.push_back(cell_dofs[i]);
    return dofs;
  }

  void SectorElements::for_each_owned_cell(
      const std::function<void(const Cell &, SolidElement &)> &visit) const
  {
    if (!dof_handler.has_active_dofs())
      return;
    SolidElement element(mapping, fe);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        element.reinit(cell, materials.at(cell->material_id()));
        visit(cell, element);
      }
  }

  void SectorElements::for_each_owned_shell_cell(
      const std::function<void(const ShellCell &, ShellElement &)> &visit) const
  {
    if (!shell_dof_handler.has_active_dofs())
      return;
    ShellElement element(shell_mapping, shell_fe);
    for (const auto &cell : shell_dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        element.reinit(cell, materials.at(cell->material_id()),
                       mesh.sections.at(cell->material_id()));
        visit(cell, element);
      }
  }

  void SectorElements::for_each_owned_bar(
      const std::function<void(const Cell &, const types::boundary_id, BarElement &)> &visit) const
  {
    if (mesh.bars.empty())
      return;
    BarElement element(mapping, fe);
    std::set<unsigned int> done; // an edge belongs to the first of its cells
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int line : cell->line_indices())
        if (const auto bar = mesh.bars.find(cell->line(line)->boundary_id());
            bar != mesh.bars.end() && done.insert(cell->line_index(line)).second &&
            cell->is_locally_owned())
        {
          element.reinit(cell, line, bar->second);
          visit(cell, bar->first, element);
        }
  }

  void SectorElements::for_each_owned_foundation(
      const std::function<void(const Cell &, const types::boundary_id, FoundationElement &)> &visit)
      const
  {
    if (mesh.foundations.empty())
      return;
    FoundationElement element(mapping, fe);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face))
            if (const auto foundation = mesh.foundations.find(cell->face(face)->boundary_id());
                foundation != mesh.foundations.end())
            {
              element.reinit(cell, face, foundation->second);
              visit(cell, foundation->first, element);
            }
  }

  namespace
  {
    Vector<double> &field_of(ComplexField &field, const unsigned int part)
    {
      return part == 0 ? field.real : field.imaginary;
    }
    const Vector<double> &field_of(const ComplexField &field, const unsigned int part)
    {
      return part == 0 ? field.real : field.imaginary;
    }
  } // namespace

  SectorMotion SectorElements::at_rest() const
  {
    const unsigned int first_shell     = sector_nodes.first_shell_dof(),
                       first_potential = sector_nodes.first_potential_dof();
    SectorMotion motion;
    for (const unsigned int part : {0u, 1u})
    {
      field_of(motion.solid, part).reinit(first_shell);
      field_of(motion.shell, part).reinit(first_potential - first_shell);
      field_of(motion.potential, part).reinit(n_dofs() - first_potential);
    }
    return motion;
  }

  SectorMotion SectorElements::to_motion(std::array<Vector<double>, 2> fields) const
  {
    SectorMotion motion = at_rest();
    for (unsigned int part = 0; part < 2; ++part)
    {
      dependent_dofs.distribute(fields[part]);
      sector_nodes.rotate_to_cartesian(fields[part]);
      auto next = fields[part].begin();
      for (ComplexField *of_part : motion.parts())
      {
        Vector<double> &field = field_of(*of_part, part);
        std::copy_n(next, field.size(), field.begin());
        next += field.size();
      }
    }
    return motion;
  }

  std::array<Vector<double>, 2> SectorElements::in_axes(const SectorMotion &motion) const
  {
    std::array<Vector<double>, 2> fields;
    for (unsigned int part = 0; part < 2; ++part)
    {
      fields[part].reinit(n_dofs());
      auto next = fields[part].begin();
      for (const ComplexField *of_part : motion.parts())
      {
        const Vector<double> &field = field_of(*of_part, part);
        next                        = std::copy(field.begin(), field.end(), next);
      }
      sector_nodes.rotate_to_axes(fields[part]);
    }
    return fields;
  }

  std::array<Vector<double>, 2> SectorElements::from_forces(const SectorMotion &forces) const
  {
    std::array<Vector<double>, 2> fields = in_axes(forces);
    for (Vector<double> &field : fields)
      for (const auto &line : dependent_dofs.get_lines())
      {
        for (const auto &[master, weight] : line.entries)
          field[master] += weight * field[line.index];
        field[line.index] = 0.;
      }
    return fields;
  }
} // namespace ringmotor
