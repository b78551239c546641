// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/eigenpairs.h>
#include <ringmotor/algebra/sparse_ldlt.h>
#include <ringmotor/elements/solid.h>
#include <ringmotor/structure/cyclic_sector.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>

#include <support/triplets.h>

#include <cmath>
#include <functional>
#include <vector>

namespace ringmotor::tests
{
  /** The eigenproblem of a whole body without any symmetry: every rank solves all of it. */
  class PlainProblem
  {
  public:
    /** Degrees of freedom for which @p fixed(component, position) holds do not move. */
    PlainProblem(const dealii::Triangulation<3> &triangulation, const MaterialTable &materials,
                 const unsigned int degree,
                 const std::function<bool(unsigned int, const dealii::Point<3> &)> &fixed)
        : mapping(2), fe(dealii::FE_Q<3>(degree), 3), dof_handler(triangulation)
    {
      using namespace dealii;
      dof_handler.distribute_dofs(fe);
      DynamicSparsityPattern dynamic(dof_handler.n_dofs());
      DoFTools::make_sparsity_pattern(dof_handler, dynamic);
      pattern.copy_from(dynamic);
      stiffness.reinit(pattern);
      mass.reinit(pattern);

      std::vector<Point<3>> positions(dof_handler.n_dofs());
      DoFTools::map_dofs_to_support_points(mapping, dof_handler, positions);
      free_number.assign(dof_handler.n_dofs(), numbers::invalid_unsigned_int);
      std::vector<types::global_dof_index> cell_dofs(fe.n_dofs_per_cell());
      FullMatrix<double> cell_stiffness(cell_dofs.size(), cell_dofs.size()),
          cell_mass(cell_stiffness);
      SolidElement element(mapping, fe);
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        element.reinit(cell, materials.at(cell->material_id()));
        element.matrices(cell_stiffness, cell_mass);
        cell->get_dof_indices(cell_dofs);
        stiffness.add(cell_dofs, cell_stiffness);
        mass.add(cell_dofs, cell_mass);
        for (unsigned int i = 0; i < cell_dofs.size(); ++i)
          if (const auto dof = cell_dofs[i];
              free_number[dof] == numbers::invalid_unsigned_int &&
              !fixed(fe.system_to_component_index(i).first, positions[dof]))
          {
            free_number[dof] = free_dofs.size();
            free_dofs.push_back(dof);
          }
      }
    }

    unsigned int n_unknowns() const { return free_dofs.size(); }

    /** How many eigenvalues lie below @p shift (rad^2/s^2). */
    unsigned int count_below(const double shift) const { return factors(shift)->n_negative(); }

    /** The @p count eigenvalues (rad^2/s^2) nearest to @p shift, ascending. */
    std::vector<double> nearest(const double shift, const unsigned int count) const
    {
      const auto factorised = factors(shift);
      ShiftInvertedPencil pencil;
      pencil.size  = n_unknowns();
      pencil.shift = shift;
      pencil.solve = [&](std::vector<double> &x) { factorised->solve(x); };
      pencil.mass  = [&](const std::vector<double> &x, std::vector<double> &product)
      { product = multiply_mass(x); };
      std::vector<double> values;
      for (const Eigenpair &pair :
           eigenpairs(pencil, EigenvalueChoice::nearest, count, generic_vector(pencil.size)))
        values.push_back(pair.value);
      return values;
    }

    /** All eigenvalues, ascending, from dense matrices (LAPACK). */
    std::vector<double> dense() const
    {
      dealii::LAPACKFullMatrix<double> k(n_unknowns(), n_unknowns()), m(n_unknowns(), n_unknowns());
      for (unsigned int row = 0; row < n_unknowns(); ++row)
        for (auto entry = stiffness.begin(free_dofs[row]); entry != stiffness.end(free_dofs[row]);
             ++entry)
          if (const unsigned int column = free_number[entry->column()];
              column != dealii::numbers::invalid_unsigned_int)
          {
            k(row, column) = entry->value();
            m(row, column) = mass(free_dofs[row], entry->column());
          }
      std::vector<dealii::Vector<double>> no_vectors;
      k.compute_generalized_eigenvalues_symmetric(m, no_vectors);
      std::vector<double> values;
      for (unsigned int i = 0; i < n_unknowns(); ++i)
        values.push_back(k.eigenvalue(i).real());
      return values;
    }

  private:
    std::unique_ptr<SparseLDLT> factors(const double shift) const
    {
      SymmetricTriplets triplets;
      for (unsigned int row = 0; row < n_unknowns(); ++row)
        for (auto entry = stiffness.begin(free_dofs[row]); entry != stiffness.end(free_dofs[row]);
             ++entry)
          if (const unsigned int column = free_number[entry->column()]; column <= row)
            triplets.add(row, column,
                         entry->value() - shift * mass(free_dofs[row], entry->column()));
      auto factors = std::make_unique<SparseLDLT>(n_unknowns(), MPI_COMM_SELF);
      factors->factorise(triplets);
      return factors;
    }

    std::vector<double> multiply_mass(const std::vector<double> &x) const
    {
      dealii::Vector<double> all(dof_handler.n_dofs()), result(dof_handler.n_dofs());
      for (unsigned int i = 0; i < n_unknowns(); ++i)
        all[free_dofs[i]] = x[i];
      mass.vmult(result, all);
      std::vector<double> product(n_unknowns());
      for (unsigned int i = 0; i < n_unknowns(); ++i)
        product[i] = result[free_dofs[i]];
      return product;
    }

    const dealii::MappingQ<3> mapping;
    const dealii::FESystem<3> fe;
    dealii::DoFHandler<3> dof_handler;
    dealii::SparsityPattern pattern;
    dealii::SparseMatrix<double> stiffness, mass;
    std::vector<unsigned int> free_number; ///< of each degree of freedom, invalid if fixed
    std::vector<dealii::types::global_dof_index> free_dofs;
  };

  /** omega^2 of a frequency in Hz. */
  inline double squared_rate(const double frequency)
  {
    return std::pow(2. * dealii::numbers::PI * frequency, 2);
  }

  /** Frequency in Hz of an eigenvalue omega^2. */
  inline double frequency_of(const double eigenvalue)
  {
    return std::sqrt(std::max(0., eigenvalue)) / (2. * dealii::numbers::PI);
  }
} // namespace ringmotor::tests
