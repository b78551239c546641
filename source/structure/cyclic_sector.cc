// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/structure/cyclic_sector.h>
#include <ringmotor/structure/sector_nodes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  CyclicSector::CyclicSector(const SectorMesh &mesh, const MaterialTable &materials,
                             const unsigned int degree)
      : mesh(mesh), materials(materials), mapping(2), fe(FE_Q<3>(degree), 3),
        dof_handler(*mesh.triangulation)
  {
    dof_handler.distribute_dofs(fe);
    nodes                = SectorNodes(dof_handler, mapping, mesh);
    scalar_hanging_nodes = nodes.scalar_hanging_node_constraints(dof_handler);
    hanging_nodes        = nodes.hanging_node_constraints(scalar_hanging_nodes);
    if (mesh.form == SectorForm::half)
      number_half_sector();
    else
      number_whole_sector();
    number_fields();
    assemble();
  }

  void CyclicSector::number_half_sector()
  {
    using Factor = Term::Factor;
    for (auto &field_terms : terms)
      field_terms.resize(dof_handler.n_dofs());
    std::array<std::vector<Terms>, 2> &field = terms;

    for (types::global_dof_index dof = 0; dof < dof_handler.n_dofs(); ++dof)
    {
      if (hanging_nodes.is_constrained(dof))
        continue;
      const bool tangential = nodes.component(dof) == 1;
      if (nodes.on(dof, ids::mirror)) // there, theta is the y direction
        field[tangential ? 1 : 0][dof].add(unknown_count++, Factor::one);
      else if (nodes.on(dof, ids::cut))
      {
        field[0][dof].add(unknown_count, tangential ? Factor::sine : Factor::cosine);
        field[1][dof].add(unknown_count, tangential ? Factor::cosine : Factor::minus_sine);
        ++unknown_count;
      }
      else
      {
        field[0][dof].add(unknown_count++, Factor::one);
        field[1][dof].add(unknown_count++, Factor::one);
      }
    }
  }

  void CyclicSector::number_whole_sector()
  {
    using Factor = Term::Factor;
    for (auto &field_terms : terms)
      field_terms.resize(dof_handler.n_dofs());

    const auto is_master = [&](const types::global_dof_index dof)
    { return !hanging_nodes.is_constrained(dof) && !nodes.on(dof, ids::cut_high); };
    unsigned int n_complex = 0;
    for (types::global_dof_index dof = 0; dof < dof_handler.n_dofs(); ++dof)
      n_complex += is_master(dof);
    unknown_count = 2 * n_complex;

    unsigned int next = 0;
    for (types::global_dof_index dof = 0; dof < dof_handler.n_dofs(); ++dof)
      if (is_master(dof))
      {
        terms[0][dof].add(next, Factor::one);
        terms[1][dof].add(n_complex + next, Factor::one);
        ++next;
      }

    // exp(-i k alpha) (a + i b) = (c a + s b) + i (c b - s a)
    for (const auto &[high, low] : nodes.partners(hanging_nodes))
    {
      const unsigned int real      = terms[0][low].term[0].unknown;
      const unsigned int imaginary = terms[1][low].term[0].unknown;
      terms[0][high].add(real, Factor::cosine);
      terms[0][high].add(imaginary, Factor::sine);
      terms[1][high].add(imaginary, Factor::cosine);
      terms[1][high].add(real, Factor::minus_sine);
    }
  }

  void CyclicSector::number_fields()
  {
    std::vector<bool> tied(unknown_count, false); // to a factor that depends on k
    for (const auto &field_terms : terms)
      for (const Terms &of_dof : field_terms)
        for (unsigned int i = 0; i < of_dof.size; ++i)
          if (of_dof.term[i].factor != Term::Factor::one)
            tied[of_dof.term[i].unknown] = true;

    for (unsigned int part = 0; part < 2; ++part)
    {
      RealField &field = fields[part];
      field.number.assign(dof_handler.n_dofs(), numbers::invalid_unsigned_int);
      for (types::global_dof_index dof = 0; dof < dof_handler.n_dofs(); ++dof)
        if (const Terms &of_dof = terms[part][dof]; of_dof.size > 0)
        {
          field.number[dof] = field.size++;
          if (tied[of_dof.term[0].unknown])
            field.cut.push_back(field.number[dof]);
          else
            field.inner.emplace_back(field.number[dof], of_dof.term[0].unknown);
        }
    }
  }

  void CyclicSector::assemble()
  {
    const MPI_Comm communicator = dof_handler.get_communicator();
    const IndexSet &owned_dofs  = dof_handler.locally_owned_dofs();
    IndexSet owned_nodes(nodes.size());
    for (const types::global_dof_index dof : owned_dofs)
      owned_nodes.add_index(nodes.node(dof));

    DynamicSparsityPattern pattern(dof_handler.n_dofs()), node_pattern(nodes.size());
    const unsigned int n_cell_dofs = fe.n_dofs_per_cell(), n_cell_nodes = n_cell_dofs / 3;
    std::vector<types::global_dof_index> cell_dofs(n_cell_dofs), cell_nodes(n_cell_nodes);
    const auto go_to = [&](const auto &cell)
    {
      cell->get_dof_indices(cell_dofs);
      for (unsigned int i = 0; i < n_cell_nodes; ++i)
        cell_nodes[i] = nodes.node(cell_dofs[fe.component_to_system_index(0, i)]);
    };
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        go_to(cell);
        hanging_nodes.add_entries_local_to_global(cell_dofs, pattern, false);
        scalar_hanging_nodes.add_entries_local_to_global(cell_nodes, node_pattern, false);
      }
    SparsityTools::distribute_sparsity_pattern(pattern, owned_dofs, communicator,
                                               complete_index_set(dof_handler.n_dofs()));
    SparsityTools::distribute_sparsity_pattern(node_pattern, owned_nodes, communicator,
                                               complete_index_set(nodes.size()));
    stiffness.reinit(owned_dofs, owned_dofs, pattern, communicator);
    node_mass.reinit(owned_nodes, owned_nodes, node_pattern, communicator);

    FullMatrix<double> cell_stiffness(n_cell_dofs, n_cell_dofs), cell_mass(cell_stiffness),
        cell_node_mass(n_cell_nodes, n_cell_nodes);
    for_each_owned_cell(
        [&](const auto &cell, SolidElement &element)
        {
          element.matrices(cell_stiffness, cell_mass);
          for (unsigned int i = 0; i < n_cell_nodes; ++i)
            for (unsigned int j = 0; j < n_cell_nodes; ++j)
              cell_node_mass(i, j) =
                  cell_mass(fe.component_to_system_index(0, i), fe.component_to_system_index(0, j));
          go_to(cell);
          nodes.rotate_to_axes(cell_dofs, cell_stiffness);
          hanging_nodes.distribute_local_to_global(cell_stiffness, cell_dofs, stiffness);
          scalar_hanging_nodes.distribute_local_to_global(cell_node_mass, cell_nodes, node_mass);
        });
    stiffness.compress(VectorOperation::add);
    node_mass.compress(VectorOperation::add);
  }

  void CyclicSector::for_each_owned_cell(const CellVisitor &visit) const
  {
    SolidElement element(mapping, fe);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        element.reinit(cell, materials.at(cell->material_id()));
        visit(cell, element);
      }
  }

  std::array<double, 4> CyclicSector::factors(const unsigned int k) const
  {
    const double pitch = 2. * numbers::PI / mesh.n_sectors;
    const double angle = k * (mesh.form == SectorForm::half ? 0.5 * pitch : pitch);
    return {{1., std::cos(angle), std::sin(angle), -std::sin(angle)}};
  }

  std::vector<CyclicSector::Tie> CyclicSector::ties(const unsigned int part,
                                                    const unsigned int k) const
  {
    const std::array<double, 4> factor = factors(k);
    const RealField &field             = fields[part];
    std::vector<Tie> ties;
    unsigned int position = 0;
    for (types::global_dof_index dof = 0; dof < dof_handler.n_dofs(); ++dof)
      if (position < field.cut.size() && field.number[dof] == field.cut[position])
      {
        const Terms &of_dof = terms[part][dof];
        for (unsigned int i = 0; i < of_dof.size; ++i)
          ties.push_back({position, of_dof.term[i].unknown,
                          factor[static_cast<unsigned int>(of_dof.term[i].factor)]});
        ++position;
      }
    return ties;
  }

  SymmetricTriplets CyclicSector::shifted_stiffness(const unsigned int part,
                                                    const double shift) const
  {
    const std::vector<unsigned int> &number = fields[part].number;
    const Epetra_CrsMatrix &k               = stiffness.trilinos_matrix();
    const Epetra_CrsMatrix &m               = node_mass.trilinos_matrix();
    SymmetricTriplets triplets;
    triplets.reserve((k.NumMyNonzeros() + number.size()) / 2);
    std::vector<double> row_of_mass(nodes.size(), 0.);
    for (int local_row = 0; local_row < k.NumMyRows(); ++local_row)
    {
      const int row = k.GRID(local_row);
      if (number[row] == numbers::invalid_unsigned_int)
        continue;
      int n_entries = 0, n_mass_entries = 0, *columns = nullptr, *mass_columns = nullptr;
      double *values = nullptr, *mass_values = nullptr;
      k.ExtractMyRowView(local_row, n_entries, values, columns);
      m.ExtractMyRowView(m.LRID(static_cast<int>(nodes.node(row))), n_mass_entries, mass_values,
                         mass_columns);
      for (int entry = 0; entry < n_mass_entries; ++entry)
        row_of_mass[m.GCID(mass_columns[entry])] = mass_values[entry];

      const Tensor<1, 3> direction = nodes.direction(row);
      for (int entry = 0; entry < n_entries; ++entry)
        if (const int column = k.GCID(columns[entry]);
            column <= row && number[column] != numbers::invalid_unsigned_int)
          triplets.add(number[row], number[column],
                       values[entry] - shift * (direction * nodes.direction(column)) *
                                           row_of_mass[nodes.node(column)]);
      for (int entry = 0; entry < n_mass_entries; ++entry)
        row_of_mass[m.GCID(mass_columns[entry])] = 0.;
    }
    return triplets;
  }

  std::array<Vector<double>, 2> CyclicSector::to_fields(const unsigned int k,
                                                        const std::vector<double> &unknowns) const
  {
    const std::array<double, 4> factor = factors(k);
    std::array<Vector<double>, 2> fields;
    for (unsigned int part = 0; part < 2; ++part)
    {
      fields[part].reinit(dof_handler.n_dofs());
      for (types::global_dof_index dof = 0; dof < dof_handler.n_dofs(); ++dof)
        for (unsigned int i = 0; i < terms[part][dof].size; ++i)
        {
          const Term &term = terms[part][dof].term[i];
          fields[part][dof] +=
              factor[static_cast<unsigned int>(term.factor)] * unknowns[term.unknown];
        }
    }
    return fields;
  }

  void CyclicSector::multiply_mass(const unsigned int k, const std::vector<double> &unknowns,
                                   std::vector<double> &product) const
  {
    // The mass knows no direction: in Cartesian components one matrix serves all of both fields.
    const std::array<Vector<double>, 2> fields = to_fields(k, unknowns);
    const Epetra_Map &owned                    = node_mass.trilinos_matrix().RowMap();
    Epetra_MultiVector motion(owned, 6), mass_times_motion(owned, 6);
    for (int row = 0; row < owned.NumMyElements(); ++row)
      for (unsigned int component = 0; component < 3; ++component)
      {
        const types::global_dof_index dof = nodes.dof(owned.GID(row), component);
        const Tensor<1, 3> direction      = nodes.direction(dof);
        for (unsigned int part = 0; part < 2; ++part)
          for (unsigned int d = 0; d < 3; ++d)
            motion[3 * part + d][row] += fields[part][dof] * direction[d];
      }
    node_mass.trilinos_matrix().Multiply(false, motion, mass_times_motion);

    const std::array<double, 4> factor = factors(k);
    product.assign(unknown_count, 0.);
    for (int row = 0; row < owned.NumMyElements(); ++row)
      for (unsigned int component = 0; component < 3; ++component)
      {
        const types::global_dof_index dof = nodes.dof(owned.GID(row), component);
        const Tensor<1, 3> direction      = nodes.direction(dof);
        for (unsigned int part = 0; part < 2; ++part)
        {
          double along = 0.;
          for (unsigned int d = 0; d < 3; ++d)
            along += direction[d] * mass_times_motion[3 * part + d][row];
          const Terms &of_row = terms[part][dof];
          for (unsigned int i = 0; i < of_row.size; ++i)
            product[of_row.term[i].unknown] +=
                factor[static_cast<unsigned int>(of_row.term[i].factor)] * along;
        }
      }
    Utilities::MPI::sum(product, dof_handler.get_communicator(), product);
  }

  std::vector<double> CyclicSector::unknowns_of(
      const unsigned int k,
      const std::function<std::array<std::complex<double>, 3>(const Point<3> &)> &displacement)
      const
  {
    std::array<Vector<double>, 2> fields{
        {Vector<double>(dof_handler.n_dofs()), Vector<double>(dof_handler.n_dofs())}};
    nodes.interpolate(displacement, fields[0], fields[1]);

    // Each unknown drives its degrees of freedom with known factors: least squares inverts that.
    const std::array<double, 4> factor = factors(k);
    std::vector<double> unknowns(unknown_count, 0.), weights(unknown_count, 0.);
    for (unsigned int part = 0; part < 2; ++part)
      for (types::global_dof_index dof = 0; dof < dof_handler.n_dofs(); ++dof)
        for (unsigned int i = 0; i < terms[part][dof].size; ++i)
        {
          const Term &term    = terms[part][dof].term[i];
          const double weight = factor[static_cast<unsigned int>(term.factor)];
          unknowns[term.unknown] += weight * fields[part][dof];
          weights[term.unknown] += weight * weight;
        }
    for (unsigned int i = 0; i < unknown_count; ++i)
      unknowns[i] /= weights[i];
    return unknowns;
  }

  ComplexField CyclicSector::expand(const unsigned int k, const std::vector<double> &unknowns) const
  {
    std::array<Vector<double>, 2> fields = to_fields(k, unknowns);
    for (Vector<double> &field : fields)
    {
      hanging_nodes.distribute(field);
      nodes.rotate_to_cartesian(field);
    }
    return {std::move(fields[0]), std::move(fields[1])};
  }
} // namespace ringmotor
