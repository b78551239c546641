// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/elements/sum_of_squares.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>

#include <vector>

namespace ringmotor
{
  /**
   * Springs that resist the motion of a face of a solid cell in FESystem(FE_Q(p), 3) along its
   * normal. Integration with (p + 1)^2 Gauss points.
   */
  class FoundationElement
  {
  public:
    FoundationElement(const dealii::Mapping<3> &mapping, const dealii::FiniteElement<3> &fe);

    /** Reinitialises for a @p face of a cell; @p stiffness is a force per area and displacement,
     * N/m^3. */
    void reinit(const dealii::Triangulation<3>::active_cell_iterator &cell, const unsigned int face,
                const double stiffness);

    /** Stiffness in N/m for the cell's local degrees of freedom. */
    void matrix(dealii::FullMatrix<double> &stiffness) const { springs.fill(stiffness); }

    /** Twice the energy, u.K u in N m, of each displacement in @p fields. */
    std::vector<double> stiffness_products(const std::vector<dealii::Vector<double>> &fields) const
    {
      return springs.products(fields);
    }

  private:
    const dealii::FiniteElement<3> &fe;
    dealii::FEFaceValues<3> scalar_values;
    SumOfSquares springs; ///< a row for each quadrature point
  };
} // namespace ringmotor
