// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sections.h>
#include <ringmotor/parameters/materials.h>

#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace ringmotor
{
  /**
   * Matrices of a part of a body of revolution for motions with n waves around its axis,
   *
   *     U = (u_r, i u_theta, u_z) exp(-i n theta),
   *
   * per radian of the body: u.K u is twice the strain energy of the real and the imaginary part of
   * U together, with K = constant + n linear + n^2 quadratic in N/m, u.M u the same of the kinetic
   * energy at unit frequency, in kg m^2. Unknowns are u_r, u_theta, u_z of the nodes in a section
   * (semi-analytic finite elements; Wilson, AIAA Journal 3, 1965).
   */
  struct WaveMatrices
  {
    dealii::FullMatrix<double> constant, linear, quadratic, mass;
  };

  /** Strains and motions of such a part, by quadrature. */
  class WaveStrains
  {
  public:
    /** The motion at a point of the section (r, theta, z components, theta without its i) by a unit
     * of an unknown, and its derivatives by r and z. */
    struct UnitMotion
    {
      dealii::Tensor<1, 3> value, by_r, by_z;
    };

    /** Starts anew, with the number of unknowns. */
    void clear(const unsigned int n_unknowns);
    /** Moves on to a point at this radius with the unit motions of all unknowns. */
    void at(const double radius, const std::vector<UnitMotion> &motions);
    /** Adds weight * (strain)^2 there; @p strain is a linear function of the displacement's
     * gradient, whose row is the component and column the direction (r, theta, z). @param beside
     * what the unknowns themselves add to it, if they do */
    void add(const double weight, const std::function<double(const dealii::Tensor<2, 3> &)> &strain,
             const std::vector<double> &beside = {});
    /** Adds the mass (kg per radian) of that point. */
    void add_mass(const double mass);

    WaveMatrices matrices() const;

  private:
    /** Rows of numbers with a weight each. */
    struct Rows
    {
      std::vector<double> weights;
      std::vector<double> constant, linear; ///< coefficients by row and unknown
    };
    dealii::FullMatrix<double> product(const Rows &rows, const std::vector<double> &left,
                                       const std::vector<double> &right) const;

    unsigned int n_unknowns                     = 0;
    const std::vector<UnitMotion> *unit_motions = nullptr;
    /** The constant and the linear part of the gradient by each unknown. */
    std::vector<std::array<dealii::Tensor<2, 3>, 2>> slopes;
    Rows strains, motions;
  };

  /** A solid of isotropic material, by a face of its cell in FESystem(FE_Q(p), 3) on the half plane
   * theta = 0; (p + 1)^2 Gauss points. */
  class SemiAnalyticSolid
  {
  public:
    SemiAnalyticSolid(const dealii::Mapping<3> &mapping, const dealii::FiniteElement<3> &fe);

    /** The local degrees of freedom of the cell on its face @p face: the unknowns. */
    std::vector<unsigned int> local_dofs(const unsigned int face) const;
    WaveMatrices matrices(const dealii::Triangulation<3>::active_cell_iterator &cell,
                          const unsigned int face, const Material &material);

  private:
    const dealii::FiniteElement<3> &fe;
    dealii::FEFaceValues<3> values;
    WaveStrains strains;
  };

  /** A shell with the kinematics of ShellElement, by an edge of its cell in FESystem(FE_Q(p), 6) on
   * the half plane theta = 0; (p + 1) x 2 Gauss points. */
  class SemiAnalyticShell
  {
  public:
    SemiAnalyticShell(const dealii::Mapping<2, 3> &mapping, const dealii::FiniteElement<2, 3> &fe);

    /** The local degrees of freedom of the cell on its edge @p edge: the unknowns. */
    const std::vector<unsigned int> &local_dofs(const unsigned int edge) const
    {
      return edges[edge].dofs;
    }
    /** @param angle rad, of the sector's part that is meshed: the rotation about the normal is tied
     * to that of the surface relative to the size of the cell */
    WaveMatrices matrices(const dealii::Triangulation<2, 3>::active_cell_iterator &cell,
                          const unsigned int edge, const Material &material,
                          const ShellSection &section, const double angle);

  private:
    /** Data that do not depend on the cell, for each of its edges. */
    struct Edge
    {
      Edge(const dealii::Mapping<2, 3> &mapping, const dealii::FiniteElement<2, 3> &fe,
           const unsigned int edge);

      std::vector<unsigned int> dofs, nodes;           ///< of the cell; nodes of the scalar element
      std::vector<double> weights;                     ///< of Gauss points along the edge
      std::vector<std::vector<double>> values, slopes; ///< by Gauss point and node of the edge
      std::unique_ptr<dealii::FEValues<2, 3>> at_nodes;
    };
    /** The section at a height above a point of the reference line. */
    struct Place
    {
      double radius, jacobian;
      dealii::Tensor<1, 3> along, normal;      ///< unit vectors
      dealii::Tensor<1, 3> of_line, of_height; ///< gradients of the two parameters
    };
    Place place_at(const Edge &edge, const unsigned int q, const double height) const;
    std::vector<WaveStrains::UnitMotion> motions_at(const Edge &edge, const unsigned int q,
                                                    const double height, const Place &place) const;
    void add_layers(const Edge &edge, const unsigned int q, const Material &material,
                    const ShellSection &section);
    void tie_drill(const Edge &edge, const unsigned int q, const double stiffness);

    const dealii::FiniteElement<2, 3> &fe;
    std::vector<Edge> edges;
    std::vector<dealii::Tensor<1, 3>> position, director; ///< by node of the edge
    std::vector<WaveStrains::UnitMotion> motions;
    WaveStrains strains;
  };
} // namespace ringmotor
