// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sector_nodes.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace ringmotor
{
  /** follows^T matrix follows: a matrix for unknowns that others follow. */
  dealii::FullMatrix<double> transformed(const dealii::FullMatrix<double> &matrix,
                                         const dealii::FullMatrix<double> &follows);

  /** What remains of the degrees of freedom of an element without those that depend on others. */
  class IndependentDofs
  {
  public:
    IndependentDofs(const std::vector<SectorNodes::Dof> &dofs,
                    const dealii::AffineConstraints<double> &dependent);

    /** First those that others of the element follow, then the rest in their order. */
    const std::vector<SectorNodes::Dof> &dofs() const { return independent; }
    /** Transforms a matrix of the element to them. */
    void condense(dealii::FullMatrix<double> &matrix) const;

  private:
    std::vector<SectorNodes::Dof> independent;
    dealii::FullMatrix<double> follows; ///< empty if nothing depends on others
    bool all_independent = true;
  };
} // namespace ringmotor
