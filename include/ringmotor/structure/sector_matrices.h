// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sector_elements.h>
#include <ringmotor/structure/sparse_ldlt.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <array>
#include <vector>

namespace ringmotor
{
  /**
   * Stiffness and mass of a sector, with no condition on the mirror plane or the cuts, in the axes
   * of the nodes; dependent degrees of freedom are eliminated.
   *
   * The mass of a solid is isotropic: one number for each pair of nodes suffices. That of a shell,
   * and of solids that follow one, couples displacements and rotations; only there is the full
   * matrix stored.
   */
  class SectorMatrices
  {
  public:
    /** @p elements must outlive this object. */
    explicit SectorMatrices(const SectorElements &elements);

    /** This rank's part of K - shift M (lower triangle) for the rows and columns that have a
     * @p number, in this numbering. */
    SymmetricTriplets shifted(const std::vector<unsigned int> &number, const double shift) const;

    /** The mass times two fields, in the rows this rank owns; zero in all others. */
    std::array<dealii::Vector<double>, 2>
    multiply_mass(const std::array<dealii::Vector<double>, 2> &fields) const;

  private:
    using Dof = SectorNodes::Dof;

    void make_patterns();
    void assemble_solids();
    void assemble_shells();
    void assemble_bars();
    void assemble_foundations();
    /** Degrees of freedom of an edge with a bar. */
    std::vector<Dof> dofs_on(const SectorElements::Cell &cell, const BarElement &bar) const;
    /** The nodes of solid degrees of freedom, those of the x component. */
    std::vector<Dof> nodes_of(const std::vector<Dof> &dofs) const;
    /** Adds an isotropic mass, given as that of a vector field. */
    void add_node_mass(const std::vector<Dof> &dofs, const dealii::FullMatrix<double> &mass);

    const SectorElements &elements;
    dealii::TrilinosWrappers::SparseMatrix stiffness;
    dealii::TrilinosWrappers::SparseMatrix node_mass; ///< of one component, by nodes
    dealii::TrilinosWrappers::SparseMatrix coupled_mass;
  };
} // namespace ringmotor
