// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/elements/sum_of_squares.h>
#include <ringmotor/mesh/sections.h>
#include <ringmotor/parameters/materials.h>

#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace ringmotor
{
  /**
   * A curved, shear-flexible shell of isotropic linear elastic material (Reissner-Mindlin
   * kinematics in the degenerated-solid form of Ahmad, Irons and Zienkiewicz, 1970): each node
   * carries its displacement u (components 0 to 2, in m) and a rotation theta (3 to 5, in rad); a
   * point z above the surface moves by u + z theta x D, where D is the normal. The normal stress
   * across the thickness is zero, the shear correction factor 5/6.
   *
   * For FESystem(FE_Q(p), 6), integrated fully with (p + 1)^2 x 2 Gauss points. Surface and normals
   * are interpolated between the nodes as the displacement is, so rigid motions cause no strain.
   * Degree 1 is the MITC4 element (Dvorkin and Bathe, 1984): its covariant transverse shear strains
   * are those at the middles of the edges. The rotation about the normal is weakly tied to the
   * rotation of the surface.
   *
   * Locking of thin shells, measured down to 1e-4 of the radius: degree 2 locks. On cells along the
   * lines of curvature the others do not; their errors fall like h^2 (degrees 1 and 3) and h^4 (4)
   * for any thickness. On distorted cells of a curved shell degrees 1 and 3 lock through their
   * membrane strains; degree 4 barely locks.
   */
  class ShellElement
  {
  public:
    static constexpr unsigned int n_layers   = 2; ///< Gauss points across the thickness
    static constexpr double shear_correction = 5. / 6.;

    ShellElement(const dealii::Mapping<2, 3> &mapping, const dealii::FiniteElement<2, 3> &fe);

    /** N/m, per area: of the tie of the rotation about the normal, in a cell of this area (m^2). */
    static double drill_stiffness(const Material &material, const ShellSection &section,
                                  const double area);

    /** Reinitialises for a shell cell with this @p material and @p section. */
    void reinit(const dealii::Triangulation<2, 3>::active_cell_iterator &cell,
                const Material &material, const ShellSection &section);

    /**
     * Stiffness and consistent mass with rotary inertia, in the order of the finite element's local
     * degrees of freedom; both symmetric and filled completely. SI units. The mass does not include
     * the rotation about the normal.
     */
    void matrices(dealii::FullMatrix<double> &stiffness, dealii::FullMatrix<double> &mass);

    /**
     * Twice the strain energy in the cell, u.K u in N m, of each field in @p fields, from its
     * strains: the matrix of a thin shell would lose digits of nearly strain-free states.
     */
    std::vector<double> stiffness_products(const std::vector<dealii::Vector<double>> &fields);

    /** u.M u in kg m^2 of each field in @p fields. */
    std::vector<double> mass_products(const std::vector<dealii::Vector<double>> &fields);

  private:
    /** The scalar shape functions at a point of the reference cell, by node. */
    struct Shapes
    {
      Shapes(const dealii::FiniteElement<2, 3> &fe, const dealii::Point<2> &point);
      std::vector<double> value;
      std::vector<dealii::Tensor<1, 2>> gradient;
    };

    /** The geometry at a point z above the surface, with the parameters xi, eta and z. */
    struct Place
    {
      std::array<dealii::Tensor<1, 3>, 3>
          axes; ///< local unit vectors, the third normal to the layer
      std::array<dealii::Tensor<1, 3>, 3> tangents,
          gradients; ///< derivatives by the parameters, and gradients of the parameters
      double volume; ///< per parameter volume
    };
    Place place_at(const Shapes &shapes, const double z) const;

    /** The motion due to a unit value of the local degree of freedom @p i: that of the surface, and
     * that of points above it per unit height. */
    struct Motion
    {
      dealii::Tensor<1, 3> surface, director;
    };
    Motion unit_motion(const unsigned int i) const;

    void build_rows();
    void fill_strains(const unsigned int q, const double z, const Place &place,
                      const unsigned int first_row);
    void tie_shear_strains(const unsigned int q, const double z, const Place &place,
                           const unsigned int first_row);
    double covariant_shear(const Shapes &shapes, const Place &place, const unsigned int direction,
                           const double z, const unsigned int i) const;
    void fill_drill(const unsigned int q, const Place &place, const unsigned int row);
    void fill_motion(const unsigned int q, const double z, const unsigned int first_row);

    const dealii::FiniteElement<2, 3> &fe;
    dealii::FEValues<2, 3> at_nodes;
    const unsigned int n_nodes;
    const dealii::Quadrature<2> points;
    std::vector<Shapes> shapes; ///< by quadrature point
    std::array<std::vector<Shapes>, 2>
        ties; ///< for the shear with xi and that with eta: the middles of two edges, degree 1 only

    std::vector<dealii::Tensor<1, 3>> position, director; ///< by node of the cell
    Material material;
    ShellSection section{};
    double area = 0.;
    SumOfSquares strains, motions; ///< twice the strain energy; u.M u
  };
} // namespace ringmotor
