// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/structure/cyclic_sector.h>
#include <ringmotor/structure/sector_nodes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/sparsity_tools.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /**
     * Calls @p use(row, column, value) for the entries of stiffness - shift * mass at or below the
     * diagonal in this rank's rows. The pattern of the mass is part of that of the stiffness.
     */
    template <typename Use>
    void for_each_lower_entry(const Epetra_CrsMatrix &stiffness, const Epetra_CrsMatrix &mass,
                              const double shift, const Use &use)
    {
      std::vector<double> row_of_mass(stiffness.NumMyCols(), 0.);
      for (int local_row = 0; local_row < stiffness.NumMyRows(); ++local_row)
      {
        int n_entries = 0, n_mass_entries = 0, *columns = nullptr, *mass_columns = nullptr;
        double *values = nullptr, *mass_values = nullptr;
        stiffness.ExtractMyRowView(local_row, n_entries, values, columns);
        mass.ExtractMyRowView(local_row, n_mass_entries, mass_values, mass_columns);
        for (int entry = 0; entry < n_mass_entries; ++entry)
          row_of_mass[stiffness.LCID(mass.GCID(mass_columns[entry]))] = mass_values[entry];

        const int row = stiffness.GRID(local_row);
        for (int entry = 0; entry < n_entries; ++entry)
        {
          double &mass_value = row_of_mass[columns[entry]];
          if (const int column = stiffness.GCID(columns[entry]); column <= row)
            use(row, column, values[entry] - shift * mass_value);
          mass_value = 0.;
        }
      }
    }
  } // namespace

  CyclicSector::CyclicSector(const SectorMesh &mesh, const MaterialTable &materials,
                             const unsigned int degree)
      : mesh(mesh), materials(materials), mapping(2), fe(FE_Q<3>(degree), 3),
        dof_handler(*mesh.triangulation)
  {
    dof_handler.distribute_dofs(fe);
    nodes         = SectorNodes(dof_handler, mapping, mesh);
    hanging_nodes = nodes.hanging_node_constraints(dof_handler);
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

  DynamicSparsityPattern CyclicSector::sparsity(const Table<2, DoFTools::Coupling> &coupling) const
  {
    DynamicSparsityPattern pattern(dof_handler.n_dofs());
    DoFTools::make_sparsity_pattern(dof_handler, coupling, pattern, hanging_nodes,
                                    /*keep_constrained_dofs =*/false);
    SparsityTools::distribute_sparsity_pattern(pattern, dof_handler.locally_owned_dofs(),
                                               dof_handler.get_communicator(),
                                               complete_index_set(dof_handler.n_dofs()));
    return pattern;
  }

  void CyclicSector::assemble()
  {
    const IndexSet &owned       = dof_handler.locally_owned_dofs();
    const MPI_Comm communicator = dof_handler.get_communicator();
    Table<2, DoFTools::Coupling> coupling(3, 3);
    coupling.fill(DoFTools::always);
    stiffness.reinit(owned, owned, sparsity(coupling), communicator);
    // The mass couples equal components only, and x with y where a cell has nodes with turned axes.
    for (unsigned int component = 0; component < 2; ++component)
      coupling(2, component) = coupling(component, 2) = DoFTools::none;
    mass.reinit(owned, owned, sparsity(coupling), communicator);

    const unsigned int n_cell_dofs = fe.n_dofs_per_cell();
    std::vector<types::global_dof_index> cell_dofs(n_cell_dofs);
    FullMatrix<double> cell_stiffness(n_cell_dofs, n_cell_dofs),
        cell_mass(n_cell_dofs, n_cell_dofs);
    for_each_owned_cell(
        [&](const auto &cell, SolidElement &element)
        {
          element.matrices(cell_stiffness, cell_mass);
          cell->get_dof_indices(cell_dofs);
          nodes.rotate_to_axes(cell_dofs, cell_stiffness);
          nodes.rotate_to_axes(cell_dofs, cell_mass);
          hanging_nodes.distribute_local_to_global(cell_stiffness, cell_dofs, stiffness);
          hanging_nodes.distribute_local_to_global(cell_mass, cell_dofs, mass);
        });
    stiffness.compress(VectorOperation::add);
    mass.compress(VectorOperation::add);
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
    SymmetricTriplets triplets;
    triplets.reserve((stiffness.trilinos_matrix().NumMyNonzeros() + number.size()) / 2);
    for_each_lower_entry(stiffness.trilinos_matrix(), mass.trilinos_matrix(), shift,
                         [&](const unsigned int row, const unsigned int column, const double value)
                         {
                           if (number[row] != numbers::invalid_unsigned_int &&
                               number[column] != numbers::invalid_unsigned_int)
                             triplets.add(number[row], number[column], value);
                         });
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
    const std::array<double, 4> factor         = factors(k);
    const std::array<Vector<double>, 2> fields = to_fields(k, unknowns);
    const Epetra_Map &owned                    = mass.trilinos_matrix().RowMap();
    Epetra_MultiVector both_fields(owned, 2), mass_times_fields(owned, 2);
    for (int part = 0; part < 2; ++part)
      for (int row = 0; row < owned.NumMyElements(); ++row)
        both_fields[part][row] = fields[part][owned.GID(row)];
    mass.trilinos_matrix().Multiply(false, both_fields, mass_times_fields);

    product.assign(unknown_count, 0.);
    for (int part = 0; part < 2; ++part)
      for (int row = 0; row < owned.NumMyElements(); ++row)
      {
        const Terms &of_row = terms[part][owned.GID(row)];
        for (unsigned int i = 0; i < of_row.size; ++i)
          product[of_row.term[i].unknown] +=
              factor[static_cast<unsigned int>(of_row.term[i].factor)] *
              mass_times_fields[part][row];
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
