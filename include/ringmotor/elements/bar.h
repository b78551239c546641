// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/elements/sum_of_squares.h>
#include <ringmotor/mesh/sections.h>

#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

namespace ringmotor
{
  /**
   * A bar along an edge of a solid cell in FESystem(FE_Q(p), 3): it moves with the edge, resists
   * stretching with the force E A (du/ds . t), where t is the tangent, and has mass but no bending
   * or torsional stiffness. Integrated with p + 1 Gauss points on the edge as curved by the
   * mapping.
   */
  class BarElement
  {
  public:
    BarElement(const dealii::Mapping<3> &mapping, const dealii::FiniteElement<3> &fe);

    /** Reinitialises for the edge with the number @p line in its @p cell. */
    void reinit(const dealii::Triangulation<3>::active_cell_iterator &cell, const unsigned int line,
                const BarSection &section);

    /** The 3 (p + 1) local degrees of freedom of the cell on the edge, ascending: the order of the
     * matrices and fields. */
    const std::vector<unsigned int> &local_dofs() const { return edges[line].dofs; }

    /** m, of the edge. */
    double length() const { return edge_length; }

    /** Stiffness in N/m and consistent mass in kg; both symmetric and filled completely. */
    void matrices(dealii::FullMatrix<double> &stiffness, dealii::FullMatrix<double> &mass);

    /** Twice the strain energy, u.K u in N m, of each displacement in @p fields. */
    std::vector<double> stiffness_products(const std::vector<dealii::Vector<double>> &fields);

    /** u.M u in kg m^2 of each displacement in @p fields. */
    std::vector<double> mass_products(const std::vector<dealii::Vector<double>> &fields);

  private:
    /** Data that do not depend on the cell, for each of its edges. */
    struct Edge
    {
      Edge(const dealii::Mapping<3> &mapping, const dealii::FiniteElement<3> &fe,
           const unsigned int line);

      dealii::Tensor<1, 3> direction; ///< in the reference cell
      std::vector<unsigned int> dofs, components;
      std::vector<std::vector<double>> values, slopes; ///< by quadrature point and local dof
      std::unique_ptr<dealii::FEValues<3>> geometry;
    };

    void build_rows(const BarSection &section);

    std::vector<Edge> edges;
    unsigned int line = 0;
    SumOfSquares strains; ///< the stretch, at each quadrature point
    SumOfSquares motions; ///< the components, at each quadrature point
    double edge_length = 0.;
  };
} // namespace ringmotor
