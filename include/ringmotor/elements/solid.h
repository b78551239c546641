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

  /** Strain energy per volume (J/m^3) as a function of strains, isotropic or by a piezoelectric law
   * at constant field. */
  class Elasticity
  {
  public:
    Elasticity() = default;
    explicit Elasticity(const Material &material);

    /** Twice the energy; @p slope (c, d) is the derivative of component c by d. */
    template <typename Slope>
    double twice_energy_density(const Slope &slope) const;

    double lambda = 0., mu = 0.; ///< Lame's constants in Pa, where there is no law
    std::optional<PiezoelectricLaw> law;
  };

  /** Integrals over a piezoelectric cell, in N m, of a displacement u and a potential phi. */
  struct ElectricProducts
  {
    double coupling   = 0.; ///< u.B phi: strain times e^T grad phi
    double dielectric = 0.; ///< phi.D phi: grad phi times eps grad phi
  };

  /**
   * A linear elastic solid in FESystem(FE_Q(p), 3), Cartesian displacement components in m: cell
   * matrices, and energies of given motions, which are much cheaper. Integration with (p + 1)^3
   * Gauss points. Local fields and matrices are in the order of the finite element's degrees of
   * freedom.
   *
   * Where the material has a piezoelectric law, a potential phi (V) in FE_Q(p) belongs to it.
   * Forces and charges on the nodes are
   *
   *     f = K u + B phi,    q = D phi - B^T u.
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
    /** Stiffness in N/m together with B in N/V and D in F of a piezoelectric cell. */
    void piezoelectric_matrices(dealii::FullMatrix<double> &stiffness,
                                dealii::FullMatrix<double> &coupling,
                                dealii::FullMatrix<double> &dielectric);

    /** Twice the strain energy in the cell, u.K u in N m, of each displacement in @p fields. */
    std::vector<double> stiffness_products(const std::vector<dealii::Vector<double>> &fields);

    /** u.M u in kg m^2 of each displacement in @p fields. */
    std::vector<double> mass_products(const std::vector<dealii::Vector<double>> &fields);

    /** Those of each displacement in @p fields and the potential in @p potentials. */
    std::vector<ElectricProducts>
    electric_products(const std::vector<dealii::Vector<double>> &fields,
                      const std::vector<dealii::Vector<double>> &potentials);

  private:
    /** The matrix of @p fields with a row for each node and three columns for each field. */
    const dealii::FullMatrix<double> &by_nodes(const std::vector<dealii::Vector<double>> &fields);
    /** Integrals of all pairs of derivatives of shape functions: rows and columns by derivative,
     * then by node. */
    void compute_gram();
    void isotropic_stiffness(dealii::FullMatrix<double> &stiffness) const;
    void anisotropic_stiffness(dealii::FullMatrix<double> &stiffness) const;
    /** Derivatives at each point (rows by point and direction) of nodal values (columns). */
    void slopes_of(const dealii::FullMatrix<double> &nodal_values,
                   dealii::FullMatrix<double> &slopes);

    const dealii::FiniteElement<3> &fe;
    dealii::FEValues<3> scalar_values;
    const unsigned int n_nodes, n_points;
    Elasticity elasticity;
    double density = 0.; ///< kg/m^3
    dealii::FullMatrix<double> gradients, weighted_gradients, gram, values, weighted_values,
        overlap, nodal, at_points;
  };
} // namespace ringmotor
