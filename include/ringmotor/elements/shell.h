// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/materials.h>

#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

namespace ringmotor
{
  /** What a shell has across its reference surface, the one that is meshed. */
  struct ShellSection
  {
    double thickness; ///< m
    double offset =
        0.; ///< m, from the reference surface to the mid-surface, along the cells' normals
  };

  /**
   * A curved, shear-flexible shell of isotropic linear elastic material (Reissner-Mindlin
   * kinematics in the degenerated-solid form of Ahmad, Irons and Zienkiewicz, 1970): each node
   * carries its displacement u (components 0 to 2, in m) and a rotation theta (3 to 5, in rad); a
   * point z above the surface moves by u + z theta x D, D the normal. No stress across the
   * thickness, shear correction 5/6.
   *
   * For FESystem(FE_Q(p), 6), integrated fully with (p + 1)^2 x 2 Gauss points. Surface and normals
   * are interpolated between the nodes as the displacement is: rigid motions strain nothing. Degree
   * 4 does not lock, degree 3 hardly down to a thickness of 1e-3 of the radius; 1 and 2 do. The
   * rotation about the normal is tied, weakly, to the turn of the surface.
   */
  class ShellElement
  {
  public:
    ShellElement(const dealii::Mapping<2, 3> &mapping, const dealii::FiniteElement<2, 3> &fe);

    /** Goes to a cell of a shell with this @p material and @p section. */
    void reinit(const dealii::Triangulation<2, 3>::active_cell_iterator &cell,
                const Material &material, const ShellSection &section);

    /**
     * Stiffness and consistent mass with rotary inertia, in the order of the finite element's local
     * degrees of freedom; both symmetric and filled completely. SI units. The mass has no rotation
     * about the normal.
     */
    void matrices(dealii::FullMatrix<double> &stiffness, dealii::FullMatrix<double> &mass);

  private:
    /** A point z above the surface: how its place depends on the parameters xi, eta and z. */
    struct Place
    {
      std::array<dealii::Tensor<1, 3>, 3>
          axes;                           ///< local unit vectors, the third normal to the layer
      dealii::Tensor<1, 3> dxi, deta, dz; ///< gradients of the parameters
      double volume;                      ///< by parameter volume
    };
    Place place_at(const unsigned int q, const double z) const;

    void fill_strains(const unsigned int q, const double z, const Place &place,
                      const unsigned int first_row);
    void fill_drill(const unsigned int q, const Place &place, const unsigned int row);
    void fill_motion(const unsigned int q, const double z, const unsigned int first_row);
    void add_product(const dealii::FullMatrix<double> &rows, const std::vector<double> &weights,
                     dealii::FullMatrix<double> &matrix);

    const dealii::FiniteElement<2, 3> &fe;
    dealii::FEValues<2, 3> at_nodes;
    const unsigned int n_nodes;
    const dealii::Quadrature<2> points;
    std::vector<std::vector<double>> shape;                  ///< by point and node
    std::vector<std::vector<dealii::Tensor<1, 2>>> gradient; ///< by point and node

    std::vector<dealii::Tensor<1, 3>> position, director; ///< by node of the cell
    Material material;
    ShellSection section{};
    double area = 0.;
    dealii::FullMatrix<double> strains, motions, weighted;
  };
} // namespace ringmotor
