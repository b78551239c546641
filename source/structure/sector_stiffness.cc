// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/dense_product.h>
#include <ringmotor/structure/independent_dofs.h>
#include <ringmotor/structure/sector_stiffness.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The entries of several vectors of all degrees of freedom at some of them. */
    std::vector<double> at(const std::vector<SectorNodes::Dof> &dofs,
                           const std::vector<double> &vectors, const std::size_t n_dofs)
    {
      std::vector<double> entries;
      for (std::size_t begin = 0; begin < vectors.size(); begin += n_dofs)
        for (const SectorNodes::Dof dof : dofs)
          entries.push_back(vectors[begin + dof]);
      return entries;
    }

    void add_at(const std::vector<SectorNodes::Dof> &dofs, const std::vector<double> &entries,
                const std::size_t n_dofs, std::vector<double> &vectors)
    {
      std::size_t entry = 0;
      for (std::size_t begin = 0; begin < vectors.size(); begin += n_dofs)
        for (const SectorNodes::Dof dof : dofs)
          vectors[begin + dof] += entries[entry++];
    }

    /** Of a symmetric matrix given by columns. */
    std::vector<double> lower_triangle(const double *matrix, const std::size_t size)
    {
      std::vector<double> lower;
      lower.reserve(size * (size + 1) / 2);
      for (std::size_t column = 0; column < size; ++column)
        lower.insert(lower.end(), matrix + column * size + column, matrix + (column + 1) * size);
      return lower;
    }

    void sum_over_ranks(std::vector<double> &numbers, MPI_Comm communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) > 1)
        Utilities::MPI::sum(numbers, communicator, numbers);
    }
  } // namespace

  SectorStiffness::SectorStiffness(const SectorElements &elements, const std::vector<bool> &stays)
      : all(elements), inner(elements.n_dofs(), false)
  {
    std::vector<bool> is_fixed = stays;
    for (const auto &line : all.dependent().get_lines())
    {
      is_fixed[line.index] = true;
      for (const auto &[master, weight] : line.entries)
        is_fixed[master] = true;
    }
    if (!all.dofs().has_active_dofs())
      return;
    const FiniteElement<3> &fe     = all.dofs().get_fe();
    const unsigned int first_inner = fe.get_first_hex_index();
    for (const auto &cell : all.dofs().active_cell_iterators())
    {
      const std::vector<Dof> dofs = all.dofs_of(cell);
      std::vector<Dof> inside(dofs.begin() + first_inner, dofs.end());
      if (all.has_potential(cell))
      {
        const std::vector<Dof> potentials = all.potential_dofs_of(cell);
        inside.insert(inside.end(), potentials.begin() + first_inner / 3, potentials.end());
      }
      if (std::none_of(inside.begin(), inside.end(), [&](const Dof dof) { return is_fixed[dof]; }))
        for (const Dof dof : inside)
          inner[dof] = true;
    }
  }

  unsigned int SectorStiffness::n_inner(const std::vector<Dof> &dofs) const
  {
    return inner[dofs.back()] ? dofs.size() - all.dofs().get_fe().get_first_hex_index() : 0;
  }

  void SectorStiffness::add_piezoelectric(const SectorElements::Cell &cell, SolidElement &element,
                                          const double shift)
  {
    const std::vector<Dof> displacements = all.dofs_of(cell),
                           potentials    = all.potential_dofs_of(cell);
    const std::size_t n_u = displacements.size(), n_phi = potentials.size();
    FullMatrix<double> stiffness(n_u, n_u), mass(n_u, n_u), coupling(n_u, n_phi),
        dielectric(n_phi, n_phi);
    element.piezoelectric_matrices(stiffness, coupling, dielectric);
    element.mass_matrix(mass);
    stiffness.add(-shift, mass);

    // Inner degrees of freedom are the last ones; local numbers from n_u on are potentials.
    const std::size_t n_u_inner = n_inner(displacements), n_phi_inner = n_u_inner / 3;
    std::vector<std::size_t> order;
    const auto append = [&](const std::size_t begin, const std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
        order.push_back(i);
    };
    append(0, n_u - n_u_inner);
    append(n_u, n_u + n_phi - n_phi_inner);
    append(n_u - n_u_inner, n_u);
    append(n_u + n_phi - n_phi_inner, n_u + n_phi);

    std::vector<Dof> dofs;
    for (const std::size_t i : order)
      dofs.push_back(i < n_u ? displacements[i] : potentials[i - n_u]);
    FullMatrix<double> matrix(n_u + n_phi, n_u + n_phi);
    for (std::size_t row = 0; row < order.size(); ++row)
      for (std::size_t column = 0; column < order.size(); ++column)
      {
        const std::size_t i = order[row], j = order[column];
        matrix(row, column) = i < n_u && j < n_u ? stiffness(i, j)
                              : i < n_u          ? coupling(i, j - n_u)
                              : j < n_u          ? coupling(j, i - n_u)
                                                 : -dielectric(i - n_u, j - n_u);
      }
    add(dofs, n_u_inner + n_phi_inner, matrix);
  }

  void SectorStiffness::compute(const double shift)
  {
    own.clear();
    cells.clear();
    FullMatrix<double> stiffness, mass;
    const auto reinit = [&](const std::size_t size)
    {
      stiffness.reinit(size, size);
      mass.reinit(size, size);
    };
    const auto add_shifted = [&](const std::vector<Dof> &dofs, const unsigned int n_inner)
    {
      stiffness.add(-shift, mass);
      add(dofs, n_inner, stiffness);
    };
    all.for_each_owned_cell(
        [&](const auto &cell, SolidElement &element)
        {
          if (all.has_potential(cell))
          {
            add_piezoelectric(cell, element, shift);
            return;
          }
          const std::vector<Dof> dofs = all.dofs_of(cell);
          reinit(dofs.size());
          element.stiffness_matrix(stiffness);
          if (shift != 0.)
            element.mass_matrix(mass);
          add_shifted(dofs, n_inner(dofs));
        });
    all.for_each_owned_shell_cell(
        [&](const auto &cell, ShellElement &element)
        {
          const std::vector<Dof> dofs = all.dofs_of(cell);
          reinit(dofs.size());
          element.matrices(stiffness, mass);
          add_shifted(dofs, 0);
        });
    all.for_each_owned_bar(
        [&](const auto &cell, const types::boundary_id, BarElement &element)
        {
          const std::vector<Dof> dofs = all.dofs_on(cell, element);
          Assert(!all.are_tied(dofs), ExcMessage("A bar on an edge that follows a shell."));
          reinit(dofs.size());
          element.matrices(stiffness, mass);
          add_shifted(dofs, 0);
        });
    add_foundations();
  }

  void SectorStiffness::add_foundations()
  {
    all.for_each_owned_foundation(
        [&](const auto &cell, const types::boundary_id, FoundationElement &element)
        {
          std::vector<Dof> dofs = all.dofs_of(cell);
          FullMatrix<double> stiffness(dofs.size(), dofs.size());
          element.matrix(stiffness);
          // A foundation acts on a face: no force on, and no motion of, the inner ones.
          const unsigned int n_outer = dofs.size() - n_inner(dofs);
          FullMatrix<double> outer(n_outer, n_outer);
          outer.fill(stiffness);
          dofs.resize(n_outer);
          add(dofs, 0, outer);
        });
  }

  void SectorStiffness::add(std::vector<Dof> dofs, const unsigned int n_inner,
                            FullMatrix<double> &matrix)
  {
    all.nodes().rotate_to_axes(dofs, matrix);
    const IndependentDofs independent(dofs, all.dependent());
    independent.condense(matrix);
    dofs = independent.dofs();
    if (!dofs.empty()) // not clamped all around
      own.push_back(n_inner > 0 ? eliminate(dofs, n_inner, matrix)
                                : Element{dofs, lower_triangle(&matrix(0, 0), dofs.size())});
  }

  SectorStiffness::Element SectorStiffness::eliminate(const std::vector<Dof> &dofs,
                                                      const unsigned int n_inner,
                                                      const FullMatrix<double> &matrix)
  {
    const std::size_t n_outer = dofs.size() - n_inner;
    Cell cell;
    cell.outer.assign(dofs.begin(), dofs.begin() + n_outer);
    cell.inner.assign(dofs.begin() + n_outer, dofs.end());
    std::vector<double> inside, across, outside;
    inside.reserve(n_inner * n_inner);
    across.reserve(n_inner * n_outer);
    outside.reserve(n_outer * n_outer);
    for (std::size_t i = 0; i < dofs.size(); ++i) // symmetric: its rows are its columns
    {
      const double *row = &matrix(i, 0);
      if (i < n_outer)
      {
        outside.insert(outside.end(), row, row + n_outer);
        across.insert(across.end(), row + n_outer, row + dofs.size());
      }
      else
        inside.insert(inside.end(), row + n_outer, row + dofs.size());
    }
    cell.factors.factorise(n_inner, std::move(inside));
    cell.response = across;
    cell.factors.solve(cell.response);
    add_product(-1., Transposed::yes, across, n_inner, cell.response, outside);
    Element element{cell.outer, lower_triangle(outside.data(), n_outer)};
    cells.push_back(std::move(cell));
    return element;
  }

  unsigned int SectorStiffness::n_negative() const
  {
    unsigned int count = 0;
    for (const Cell &cell : cells)
      count += cell.factors.n_negative();
    return Utilities::MPI::sum(count, all.communicator());
  }

  void SectorStiffness::condense(std::vector<double> &loads) const
  {
    const std::size_t n_dofs    = all.n_dofs();
    const std::size_t n_vectors = loads.size() / n_dofs;
    std::vector<double> left(loads.size(), 0.);
    for (const Cell &cell : cells)
    {
      std::vector<double> outer(n_vectors * cell.outer.size(), 0.);
      add_product(-1., Transposed::yes, cell.response, cell.inner.size(),
                  at(cell.inner, loads, n_dofs), outer);
      add_at(cell.outer, outer, n_dofs, left);
    }
    sum_over_ranks(left, all.communicator());
    for (std::size_t i = 0; i < loads.size(); ++i)
      loads[i] += left[i];
  }

  void SectorStiffness::expand(const std::vector<double> &loads, std::vector<double> &motions)
  {
    const std::size_t n_dofs = all.n_dofs();
    std::vector<double> follows(motions.size(), 0.);
    for (Cell &cell : cells)
    {
      std::vector<double> inside = at(cell.inner, loads, n_dofs);
      cell.factors.solve(inside);
      add_product(-1., Transposed::no, cell.response, cell.outer.size(),
                  at(cell.outer, motions, n_dofs), inside);
      add_at(cell.inner, inside, n_dofs, follows);
    }
    sum_over_ranks(follows, all.communicator());
    for (std::size_t i = 0; i < motions.size(); ++i)
      if (inner[i % n_dofs])
        motions[i] = follows[i];
  }
} // namespace ringmotor
