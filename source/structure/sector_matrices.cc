// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/sector_matrices.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>

namespace ringmotor
{
  using namespace dealii;

  SectorMatrices::SectorMatrices(const SectorElements &elements) : elements(elements)
  {
    make_patterns();
    assemble_solids();
    assemble_shells();
    assemble_bars();
    assemble_foundations();
    for (TrilinosWrappers::SparseMatrix *matrix : {&stiffness, &node_mass, &coupled_mass})
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

  std::vector<SectorMatrices::Dof> SectorMatrices::nodes_of(const std::vector<Dof> &dofs) const
  {
    std::vector<Dof> nodes;
    for (const Dof dof : dofs)
      if (elements.nodes().component(dof) == 0)
        nodes.push_back(elements.nodes().node(dof));
    return nodes;
  }

  std::vector<SectorMatrices::Dof> SectorMatrices::dofs_on(const SectorElements::Cell &cell,
                                                           const BarElement &bar) const
  {
    const std::vector<Dof> cell_dofs = elements.dofs_of(cell);
    std::vector<Dof> dofs;
    for (const unsigned int i : bar.local_dofs())
      dofs.push_back(cell_dofs[i]);
    return dofs;
  }

  void SectorMatrices::make_patterns()
  {
    const SectorNodes &nodes  = elements.nodes();
    const IndexSet owned_dofs = elements.owned_dofs();
    IndexSet owned_nodes(nodes.size());
    for (const Dof dof : owned_dofs)
      owned_nodes.add_index(nodes.node(dof));

    // The edges with bars belong to cells, so their entries are already there.
    DynamicSparsityPattern pattern(elements.n_dofs()), coupled_pattern(elements.n_dofs()),
        node_pattern(nodes.size());
    const auto add_coupled = [&](const std::vector<Dof> &dofs)
    { elements.dependent().add_entries_local_to_global(dofs, coupled_pattern, false); };
    elements.for_each_owned_cell(
        [&](const auto &cell, SolidElement &)
        {
          const std::vector<Dof> dofs = elements.dofs_of(cell);
          elements.dependent().add_entries_local_to_global(dofs, pattern, false);
          elements.scalar_hanging_nodes().add_entries_local_to_global(nodes_of(dofs), node_pattern,
                                                                      false);
          if (elements.are_tied(dofs))
            add_coupled(dofs);
        });
    elements.for_each_owned_shell_cell(
        [&](const auto &cell, ShellElement &)
        {
          const std::vector<Dof> dofs = elements.dofs_of(cell);
          elements.dependent().add_entries_local_to_global(dofs, pattern, false);
          add_coupled(dofs);
        });
    reinit(stiffness, pattern, owned_dofs, elements.communicator());
    reinit(node_mass, node_pattern, owned_nodes, elements.communicator());
    reinit(coupled_mass, coupled_pattern, owned_dofs, elements.communicator());
  }

  void SectorMatrices::add_node_mass(const std::vector<Dof> &dofs, const FullMatrix<double> &mass)
  {
    std::vector<unsigned int> first_components;
    for (unsigned int i = 0; i < dofs.size(); ++i)
      if (elements.nodes().component(dofs[i]) == 0)
        first_components.push_back(i);
    FullMatrix<double> scalar(first_components.size(), first_components.size());
    scalar.extract_submatrix_from(mass, first_components, first_components);
    elements.scalar_hanging_nodes().distribute_local_to_global(scalar, nodes_of(dofs), node_mass);
  }

  void SectorMatrices::assemble_solids()
  {
    const unsigned int n_cell_dofs =
        elements.dofs().has_active_dofs() ? elements.dofs().get_fe().n_dofs_per_cell() : 0;
    FullMatrix<double> cell_stiffness(n_cell_dofs, n_cell_dofs), cell_mass(cell_stiffness);
    elements.for_each_owned_cell(
        [&](const auto &cell, SolidElement &element)
        {
          element.matrices(cell_stiffness, cell_mass);
          const std::vector<Dof> dofs = elements.dofs_of(cell);
          elements.nodes().rotate_to_axes(dofs, cell_stiffness);
          elements.dependent().distribute_local_to_global(cell_stiffness, dofs, stiffness);
          if (elements.are_tied(dofs))
          {
            elements.nodes().rotate_to_axes(dofs, cell_mass);
            elements.dependent().distribute_local_to_global(cell_mass, dofs, coupled_mass);
          }
          else
            add_node_mass(dofs, cell_mass);
        });
  }

  void SectorMatrices::assemble_shells()
  {
    const unsigned int n_cell_dofs = elements.shell_dofs().has_active_dofs()
                                         ? elements.shell_dofs().get_fe().n_dofs_per_cell()
                                         : 0;
    FullMatrix<double> cell_stiffness(n_cell_dofs, n_cell_dofs), cell_mass(cell_stiffness);
    elements.for_each_owned_shell_cell(
        [&](const auto &cell, ShellElement &element)
        {
          element.matrices(cell_stiffness, cell_mass);
          const std::vector<Dof> dofs = elements.dofs_of(cell);
          for (const auto &[local, global] : {std::make_pair(&cell_stiffness, &stiffness),
                                              std::make_pair(&cell_mass, &coupled_mass)})
          {
            elements.nodes().rotate_to_axes(dofs, *local);
            elements.dependent().distribute_local_to_global(*local, dofs, *global);
          }
        });
  }

  void SectorMatrices::assemble_bars()
  {
    FullMatrix<double> bar_stiffness, bar_mass;
    elements.for_each_owned_bar(
        [&](const auto &cell, const types::boundary_id, BarElement &element)
        {
          const std::vector<Dof> dofs = dofs_on(cell, element);
          Assert(!elements.are_tied(dofs), ExcMessage("A bar on an edge that follows a shell."));
          bar_stiffness.reinit(dofs.size(), dofs.size());
          bar_mass.reinit(dofs.size(), dofs.size());
          element.matrices(bar_stiffness, bar_mass);
          elements.nodes().rotate_to_axes(dofs, bar_stiffness);
          elements.dependent().distribute_local_to_global(bar_stiffness, dofs, stiffness);
          add_node_mass(dofs, bar_mass);
        });
  }

  void SectorMatrices::assemble_foundations()
  {
    FullMatrix<double> cell_stiffness;
    elements.for_each_owned_foundation(
        [&](const auto &cell, const types::boundary_id, FoundationElement &element)
        {
          const std::vector<Dof> dofs = elements.dofs_of(cell);
          cell_stiffness.reinit(dofs.size(), dofs.size());
          element.matrix(cell_stiffness);
          elements.nodes().rotate_to_axes(dofs, cell_stiffness);
          elements.dependent().distribute_local_to_global(cell_stiffness, dofs, stiffness);
        });
  }

  SymmetricTriplets SectorMatrices::shifted(const std::vector<unsigned int> &number,
                                            const double shift) const
  {
    const SectorNodes &nodes          = elements.nodes();
    const Epetra_CrsMatrix &k         = stiffness.trilinos_matrix();
    const Epetra_CrsMatrix &m         = node_mass.trilinos_matrix();
    const Epetra_CrsMatrix &m_coupled = coupled_mass.trilinos_matrix();
    SymmetricTriplets triplets;
    triplets.reserve((k.NumMyNonzeros() + number.size()) / 2);
    std::vector<double> row_of_mass(nodes.size(), 0.), row_of_coupled(elements.n_dofs(), 0.);
    for (int local_row = 0; local_row < k.NumMyRows(); ++local_row)
    {
      const int row = k.GRID(local_row);
      if (number[row] == numbers::invalid_unsigned_int)
        continue;
      const RowView of_stiffness(k, local_row), of_coupled(m_coupled, local_row),
          of_mass(m, m.LRID(static_cast<int>(nodes.node(row))));
      for (int entry = 0; entry < of_mass.size(); ++entry)
        row_of_mass[of_mass.column(entry)] = of_mass.value(entry);
      for (int entry = 0; entry < of_coupled.size(); ++entry)
        row_of_coupled[of_coupled.column(entry)] = of_coupled.value(entry);

      const Tensor<1, 3> direction = nodes.direction(row);
      for (int entry = 0; entry < of_stiffness.size(); ++entry)
        if (const int column = of_stiffness.column(entry);
            column <= row && number[column] != numbers::invalid_unsigned_int)
          triplets.add(number[row], number[column],
                       of_stiffness.value(entry) - shift * (direction * nodes.direction(column) *
                                                                row_of_mass[nodes.node(column)] +
                                                            row_of_coupled[column]));
      for (int entry = 0; entry < of_mass.size(); ++entry)
        row_of_mass[of_mass.column(entry)] = 0.;
      for (int entry = 0; entry < of_coupled.size(); ++entry)
        row_of_coupled[of_coupled.column(entry)] = 0.;
    }
    return triplets;
  }

  std::array<Vector<double>, 2>
  SectorMatrices::multiply_mass(const std::array<Vector<double>, 2> &fields) const
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
