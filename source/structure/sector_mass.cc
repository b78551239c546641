// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/sector_mass.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>

namespace ringmotor
{
  using namespace dealii;

  SectorMass::SectorMass(const SectorElements &elements) : elements(elements)
  {
    make_patterns();
    assemble_solids();
    assemble_shells();
    assemble_bars();
    for (TrilinosWrappers::SparseMatrix *matrix : {&node_mass, &coupled_mass})
      matrix->compress(VectorOperation::add);
  }

  namespace
  {
    void reinit(TrilinosWrappers::SparseMatrix &matrix, DynamicSparsityPattern &pattern,
                const IndexSet &owned, MPI_Comm communicator)
    {
      SparsityTools::distribute_sparsity_pattern(pattern, owned, communicator,
                                                 complete_index_set(pattern.n_rows()));
      matrix.reinit(owned, owned, pattern, communicator);
    }

    /** This rank's row of a matrix: values and global columns of its entries. */
    class RowView
    {
    public:
      RowView(const Epetra_CrsMatrix &matrix, const int local_row) : matrix(matrix)
      {
        matrix.ExtractMyRowView(local_row, n_entries, values, columns);
      }
      int size() const { return n_entries; }
      int column(const int entry) const { return matrix.GCID(columns[entry]); }
      double value(const int entry) const { return values[entry]; }

    private:
      const Epetra_CrsMatrix &matrix;
      int n_entries = 0, *columns = nullptr;
      double *values = nullptr;
    };
  } // namespace

  std::vector<SectorMass::Dof> SectorMass::nodes_of(const std::vector<Dof> &dofs) const
  {
    std::vector<Dof> nodes;
    for (const Dof dof : dofs)
      if (elements.nodes().component(dof) == 0)
        nodes.push_back(elements.nodes().node(dof));
    return nodes;
  }

  void SectorMass::make_patterns()
  {
    const SectorNodes &nodes  = elements.nodes();
    const IndexSet owned_dofs = elements.owned_dofs();
    IndexSet owned_nodes(nodes.size());
    for (const Dof dof : owned_dofs)
      owned_nodes.add_index(nodes.node(dof));

    // The edges with bars belong to cells, so their entries are already there.
    DynamicSparsityPattern coupled_pattern(elements.n_dofs()), node_pattern(nodes.size());
    const auto add_coupled = [&](const std::vector<Dof> &dofs)
    { elements.dependent().add_entries_local_to_global(dofs, coupled_pattern, false); };
    elements.for_each_owned_cell(
        [&](const auto &cell, SolidElement &)
        {
          const std::vector<Dof> dofs = elements.dofs_of(cell);
          elements.scalar_hanging_nodes().add_entries_local_to_global(nodes_of(dofs), node_pattern,
                                                                      false);
          if (elements.are_tied(dofs))
            add_coupled(dofs);
        });
    elements.for_each_owned_shell_cell(
        [&](const auto &cell, ShellElement &)
        {
          const std::vector<Dof> dofs = elements.dofs_of(cell);
          add_coupled(dofs);
        });
    reinit(node_mass, node_pattern, owned_nodes, elements.communicator());
    reinit(coupled_mass, coupled_pattern, owned_dofs, elements.communicator());
  }

  void SectorMass::add_node_mass(const std::vector<Dof> &dofs, const FullMatrix<double> &mass)
  {
    std::vector<unsigned int> first_components;
    for (unsigned int i = 0; i < dofs.size(); ++i)
      if (elements.nodes().component(dofs[i]) == 0)
        first_components.push_back(i);
    FullMatrix<double> scalar(first_components.size(), first_components.size());
    scalar.extract_submatrix_from(mass, first_components, first_components);
    elements.scalar_hanging_nodes().distribute_local_to_global(scalar, nodes_of(dofs), node_mass);
  }

  void SectorMass::assemble_solids()
  {
    FullMatrix<double> mass;
    elements.for_each_owned_cell(
        [&](const auto &cell, SolidElement &element)
        {
          const std::vector<Dof> dofs = elements.dofs_of(cell);
          mass.reinit(dofs.size(), dofs.size());
          element.mass_matrix(mass);
          if (!elements.are_tied(dofs))
          {
            add_node_mass(dofs, mass);
            return;
          }
          elements.nodes().rotate_to_axes(dofs, mass);
          elements.dependent().distribute_local_to_global(mass, dofs, coupled_mass);
        });
  }

  void SectorMass::assemble_shells()
  {
    FullMatrix<double> stiffness, mass;
    elements.for_each_owned_shell_cell(
        [&](const auto &cell, ShellElement &element)
        {
          const std::vector<Dof> dofs = elements.dofs_of(cell);
          stiffness.reinit(dofs.size(), dofs.size());
          mass.reinit(dofs.size(), dofs.size());
          element.matrices(stiffness, mass);
          elements.nodes().rotate_to_axes(dofs, mass);
          elements.dependent().distribute_local_to_global(mass, dofs, coupled_mass);
        });
  }

  void SectorMass::assemble_bars()
  {
    FullMatrix<double> stiffness, mass;
    elements.for_each_owned_bar(
        [&](const auto &cell, const types::boundary_id, BarElement &element)
        {
          const std::vector<Dof> dofs = elements.dofs_on(cell, element);
          stiffness.reinit(dofs.size(), dofs.size());
          mass.reinit(dofs.size(), dofs.size());
          element.matrices(stiffness, mass);
          add_node_mass(dofs, mass);
        });
  }

  std::array<Vector<double>, 2>
  SectorMass::multiply(const std::array<Vector<double>, 2> &fields) const
  {
    // The mass by nodes is isotropic: one matrix serves all Cartesian components of both fields.
    const SectorNodes &nodes = elements.nodes();
    const Epetra_Map &owned  = node_mass.trilinos_matrix().RowMap();
    Epetra_MultiVector motion(owned, 6), mass_times_motion(owned, 6);
    for (int row = 0; row < owned.NumMyElements(); ++row)
      for (unsigned int component = 0; component < 3; ++component)
      {
        const Dof dof                = nodes.dof(owned.GID(row), component);
        const Tensor<1, 3> direction = nodes.direction(dof);
        for (unsigned int part = 0; part < 2; ++part)
          for (unsigned int d = 0; d < 3; ++d)
            motion[3 * part + d][row] += fields[part][dof] * direction[d];
      }
    node_mass.trilinos_matrix().Multiply(false, motion, mass_times_motion);

    std::array<Vector<double>, 2> products{
        {Vector<double>(elements.n_dofs()), Vector<double>(elements.n_dofs())}};
    for (int row = 0; row < owned.NumMyElements(); ++row)
      for (unsigned int component = 0; component < 3; ++component)
      {
        const Dof dof                = nodes.dof(owned.GID(row), component);
        const Tensor<1, 3> direction = nodes.direction(dof);
        for (unsigned int part = 0; part < 2; ++part)
          for (unsigned int d = 0; d < 3; ++d)
            products[part][dof] += direction[d] * mass_times_motion[3 * part + d][row];
      }
    const Epetra_CrsMatrix &coupled = coupled_mass.trilinos_matrix();
    for (int local_row = 0; local_row < coupled.NumMyRows(); ++local_row)
    {
      const RowView row(coupled, local_row);
      for (int entry = 0; entry < row.size(); ++entry)
        for (unsigned int part = 0; part < 2; ++part)
          products[part][coupled.GRID(local_row)] +=
              row.value(entry) * fields[part][row.column(entry)];
    }
    return products;
  }
} // namespace ringmotor
