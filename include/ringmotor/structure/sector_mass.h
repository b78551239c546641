// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sector_elements.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <array>
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

    /** The mass times two fields, in the rows this rank owns; zero in all others. */
    std::array<dealii::Vector<double>, 2>
    multiply(const std::array<dealii::Vector<double>, 2> &fields) const;

  private:
    using Dof = SectorNodes::Dof;

    void make_patterns();
    void assemble_solids();
    void assemble_shells();
    void assemble_bars();
    /** The nodes of solid degrees of freedom, those of the x component. */
    std::vector<Dof> nodes_of(const std::vector<Dof> &dofs) const;
    /** Adds an isotropic mass, given as that of a vector field. */
    void add_node_mass(const std::vector<Dof> &dofs, const dealii::FullMatrix<double> &mass);

    const SectorElements &elements;
    dealii::TrilinosWrappers::SparseMatrix node_mass; ///< of one component, by nodes
    dealii::TrilinosWrappers::SparseMatrix coupled_mass;
  };
} // namespace ringmotor
