// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sector_elements.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace ringmotor
{
  /**
   * The mass of a sector, with no condition on the mirror plane or the cuts, in the axes of the
   * nodes; dependent degrees of freedom are eliminated.
   *
   * The mass of a solid is isotropic: one number for each pair of nodes suffices. That of a shell,
   * and of solids that follow one, couples displacements and rotations; only there is the full
   * matrix stored.
   */
  class SectorMass
  {
  public:
    /** @p elements must outlive this object. */
    explicit SectorMass(const SectorElements &elements);

    /** The mass times fields on all degrees of freedom, one after the other: this rank's part, the
     * rows it owns; zero in all others. */
    std::vector<double> multiply(const std::vector<double> &fields) const;

  private:
    using Dof    = SectorNodes::Dof;
    using Matrix = dealii::TrilinosWrappers::SparseMatrix;

    /** The rows of a matrix that this rank owns, in compressed form. */
    struct Rows
    {
      std::vector<Dof> row;           ///< numbers of these rows
      std::vector<std::size_t> begin; ///< of each row in the following, then their end
      std::vector<Dof> column;
      std::vector<double> value;
    };

    static Rows rows_of(const Matrix &matrix);
    void make_patterns(Matrix &of_nodes, Matrix &coupled) const;
    void assemble_solids(Matrix &of_nodes, Matrix &coupled) const;
    void assemble_shells(Matrix &coupled) const;
    void assemble_bars(Matrix &of_nodes) const;
    /** The nodes of solid degrees of freedom, those of the x component. */
    std::vector<Dof> nodes_of(const std::vector<Dof> &dofs) const;
    /** Adds an isotropic mass, given as that of a vector field. */
    void add_node_mass(const std::vector<Dof> &dofs, const dealii::FullMatrix<double> &mass,
                       Matrix &of_nodes) const;

    const SectorElements &elements;
    Rows node_mass; ///< of one component, by nodes
    Rows coupled_mass;
  };
} // namespace ringmotor
