// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/materials.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/full_matrix.h>

namespace ringmotor
{
  /**
   * Cell matrices of an isotropic linear elastic solid for FESystem(FE_Q(p), 3), Cartesian
   * displacement components in m. Integration with (p + 1)^3 Gauss points.
   */
  class SolidElement
  {
  public:
    SolidElement(const dealii::Mapping<3> &mapping, const dealii::FiniteElement<3> &fe);

    /**
     * Stiffness in N/m and consistent mass in kg of @p cell, rows and columns in the order of the
     * finite element's local degrees of freedom; both symmetric and filled completely.
     */
    void compute(const dealii::Triangulation<3>::active_cell_iterator &cell,
                 const Material &material, dealii::FullMatrix<double> &stiffness,
                 dealii::FullMatrix<double> &mass);

  private:
    const dealii::FiniteElement<3> &fe;
    dealii::FEValues<3> scalar_values;
    unsigned int n_nodes;
    dealii::FullMatrix<double> gradients, weighted_gradients, gram, values, weighted_values,
        overlap;
  };
} // namespace ringmotor
