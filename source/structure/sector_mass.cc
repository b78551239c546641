// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/sector_mass.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <array>

namespace ringmotor
{
  using namespace dealii;

  SectorMass::SectorMass(const SectorElements &elements) : elements(elements)
  {
    Matrix of_nodes, coupled;
    make_patterns(of_nodes, coupled);
    assemble_solids(of_nodes, coupled);
    assemble_shells(coupled);
    assemble_bars(of_nodes);
    for (Matrix *matrix : {&of_nodes, &coupled})
      matrix->compress(VectorOperation::add);
    node_mass    = rows_of(of_nodes);
    coupled_mass = rows_of(coupled);
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
  } // namespace

  SectorMass::Rows SectorMass::rows_of(const Matrix &matrix)
  {
    const Epetra_CrsMatrix &of_rank = matrix.trilinos_matrix();
    Rows rows;
    for (int row = 0; row < of_rank.NumMyRows(); ++row)
    {
      int n_entries = 0, *columns = nullptr;
      double *values = nullptr;
      of_rank.ExtractMyRowView(row, n_entries, values, columns);
      rows.row.push_back(of_rank.GRID(row));
      rows.begin.push_back(rows.value.size());
      for (int entry = 0; entry < n_entries; ++entry)
      {
        rows.column.push_back(of_rank.GCID(columns[entry]));
        rows.value.push_back(values[entry]);
      }
    }
    rows.begin.push_back(rows.value.size());
    return rows;
  }

  std::vector<SectorMass::Dof> SectorMass::nodes_of(const std::vector<Dof> &dofs) const
  {
    std::vector<Dof> nodes;
    for (const Dof dof : dofs)
      if (elements.nodes().component(dof) == 0)
        nodes.push_back(elements.nodes().node(dof));
    return nodes;
  }

  void SectorMass::make_patterns(Matrix &of_nodes, Matrix &coupled) const
  {
    const SectorNodes &nodes  = elements.nodes();
    const IndexSet owned_dofs = elements.owned_dofs();
    IndexSet owned_nodes(nodes.size());
    for (const Dof dof : owned_dofs)
      owned_nodes.add_index(nodes.node(dof));

    // The edges with bars belong to cells, so their entries are already there.
    // Patterns that are distributed need a set of rows in deal.II 9.6, even if it is all.
    DynamicSparsityPattern coupled_pattern(complete_index_set(elements.n_dofs())),
        node_pattern(complete_index_set(nodes.size()));
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
    reinit(of_nodes, node_pattern, owned_nodes, elements.communicator());
    reinit(coupled, coupled_pattern, owned_dofs, elements.communicator());
  }

  void SectorMass::add_node_mass(const std::vector<Dof> &dofs, const FullMatrix<double> &mass,
                                 Matrix &of_nodes) const
  {
    std::vector<unsigned int> first_components;
    for (unsigned int i = 0; i < dofs.size(); ++i)
      if (elements.nodes().component(dofs[i]) == 0)
        first_components.push_back(i);
    FullMatrix<double> scalar(first_components.size(), first_components.size());
    scalar.extract_submatrix_from(mass, first_components, first_components);
    elements.scalar_hanging_nodes().distribute_local_to_global(scalar, nodes_of(dofs), of_nodes);
  }

  void SectorMass::assemble_solids(Matrix &of_nodes, Matrix &coupled) const
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
            add_node_mass(dofs, mass, of_nodes);
            return;
          }
          elements.nodes().rotate_to_axes(dofs, mass);
          elements.dependent().distribute_local_to_global(mass, dofs, coupled);
        });
  }

  void SectorMass::assemble_shells(Matrix &coupled) const
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
          elements.dependent().distribute_local_to_global(mass, dofs, coupled);
        });
  }

  void SectorMass::assemble_bars(Matrix &of_nodes) const
  {
    FullMatrix<double> stiffness, mass;
    elements.for_each_owned_bar(
        [&](const auto &cell, const types::boundary_id, BarElement &element)
        {
          const std::vector<Dof> dofs = elements.dofs_on(cell, element);
          stiffness.reinit(dofs.size(), dofs.size());
          mass.reinit(dofs.size(), dofs.size());
          element.matrices(stiffness, mass);
          add_node_mass(dofs, mass, of_nodes);
        });
  }

  std::vector<double> SectorMass::multiply(const std::vector<double> &fields) const
  {
    // The mass by nodes is isotropic: one matrix serves all Cartesian components of all fields.
    const SectorNodes &nodes = elements.nodes();
    const std::size_t n_dofs = elements.n_dofs(), n_fields = fields.size() / n_dofs;
    // Values of a node lie side by side, in groups of a size that compilers can make fast.
    constexpr std::size_t group = 6;
    const std::size_t n_values  = (3 * n_fields + group - 1) / group * group;
    std::vector<double> motion(nodes.size() * n_values, 0.), inertia(n_values),
        products(fields.size(), 0.);
    for (std::size_t dof = 0; dof < n_dofs; ++dof)
    {
      const Tensor<1, 3> direction = nodes.direction(dof);
      double *values               = motion.data() + nodes.node(dof) * n_values;
      for (std::size_t field = 0; field < n_fields; ++field)
        for (unsigned int d = 0; d < 3; ++d)
          values[3 * field + d] += fields[field * n_dofs + dof] * direction[d];
    }
    for (std::size_t r = 0; r < node_mass.row.size(); ++r)
    {
      for (std::size_t first = 0; first < n_values; first += group)
      {
        std::array<double, group> sum{};
        for (std::size_t entry = node_mass.begin[r]; entry < node_mass.begin[r + 1]; ++entry)
        {
          const double *values = motion.data() + node_mass.column[entry] * n_values + first;
          for (std::size_t i = 0; i < group; ++i)
            sum[i] += node_mass.value[entry] * values[i];
        }
        std::copy(sum.begin(), sum.end(), inertia.begin() + first);
      }
      for (unsigned int component = 0; component < nodes.n_components(node_mass.row[r]);
           ++component)
      {
        const Dof dof                = nodes.dof(node_mass.row[r], component);
        const Tensor<1, 3> direction = nodes.direction(dof);
        for (std::size_t field = 0; field < n_fields; ++field)
          for (unsigned int d = 0; d < 3; ++d)
            products[field * n_dofs + dof] += direction[d] * inertia[3 * field + d];
      }
    }
    for (std::size_t r = 0; r < coupled_mass.row.size(); ++r)
      for (std::size_t entry = coupled_mass.begin[r]; entry < coupled_mass.begin[r + 1]; ++entry)
        for (std::size_t field = 0; field < n_fields; ++field)
          products[field * n_dofs + coupled_mass.row[r]] +=
              coupled_mass.value[entry] * fields[field * n_dofs + coupled_mass.column[entry]];
    return products;
  }
} // namespace ringmotor
