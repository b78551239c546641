// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/materials.h>

#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace ringmotor
{
  /** Strain energy per volume (J/m^3) of a linear elastic material for this displacement gradient:
   * row c holds the derivatives of component c. */
  double strain_energy_density(const Material &material,
                               const dealii::Tensor<2, 3> &displacement_gradient);

  /**
   * An isotropic linear elastic solid in FESystem(FE_Q(p), 3), Cartesian displacement components in
   * m: cell matrices, and energies of given motions, which are much cheaper. Integration with
   * (p + 1)^3 Gauss points. Local fields and matrices are in the order of the finite element's
   * degrees of freedom.
   */
  class SolidElement
  {
  public:
    SolidElement(const dealii::Mapping<3> &mapping, const dealii::FiniteElement<3> &fe);

    /** Reinitialises for a cell made of @p material. */
    void reinit(const dealii::Triangulation<3>::active_cell_iterator &cell,
                const Material &material);

    /** Stiffness in N/m and consistent mass in kg of the cell; both symmetric and filled
     * completely. */
    void matrices(dealii::FullMatrix<double> &stiffness, dealii::FullMatrix<double> &mass)
    {
      stiffness_matrix(stiffness);
      mass_matrix(mass);
    }
    void stiffness_matrix(dealii::FullMatrix<double> &stiffness);
    void mass_matrix(dealii::FullMatrix<double> &mass);

    /** Twice the strain energy in the cell, u.K u in N m, of each displacement in @p fields. */
    std::vector<double> stiffness_products(const std::vector<dealii::Vector<double>> &fields);

    /** u.M u in kg m^2 of each displacement in @p fields. */
    std::vector<double> mass_products(const std::vector<dealii::Vector<double>> &fields);

  private:
    /** The matrix of @p fields with a row for each node and three columns for each field. */
    const dealii::FullMatrix<double> &by_nodes(const std::vector<dealii::Vector<double>> &fields);

    const dealii::FiniteElement<3> &fe;
    dealii::FEValues<3> scalar_values;
    const unsigned int n_nodes, n_points;
    double lambda = 0., mu = 0., density = 0.; ///< Lame's constants in Pa, density in kg/m^3
    dealii::FullMatrix<double> gradients, weighted_gradients, gram, values, weighted_values,
        overlap, nodal, at_points;
  };
} // namespace ringmotor
