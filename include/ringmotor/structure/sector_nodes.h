// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <complex>
#include <functional>
#include <utility>
#include <vector>

namespace ringmotor
{
  /**
   * The nodes of a vector-valued FE_Q on a sector: which three degrees of freedom belong together,
   * which nodes lie on the mirror plane or on a cut, and the axes used there. On a cut the degrees
   * of freedom of a node mean its (r, theta, z) components, elsewhere (x, y, z).
   */
  class SectorNodes
  {
  public:
    using Dof = dealii::types::global_dof_index;

    /** No nodes: to be assigned to. */
    SectorNodes() = default;

    /**
     * Finds the nodes of @p dof_handler.
     * @throws UserError if the mirror plane is not theta = 0, the half sector's cut is not
     *         theta = alpha/2, or such faces are missing.
     */
    SectorNodes(const dealii::DoFHandler<3> &dof_handler, const dealii::Mapping<3> &mapping,
                const SectorMesh &mesh);

    /** True if the node of @p dof lies on a face with this boundary id (mirror or one of the cuts).
     */
    bool on(const Dof dof, const dealii::types::boundary_id boundary) const;

    /** 0, 1, 2 for x, y, z or, on a cut, for r, theta, z. */
    unsigned int component(const Dof dof) const { return place[dof].component; }

    unsigned int size() const { return nodes.size(); }

    /** The node of a degree of freedom, and back. */
    unsigned int node(const Dof dof) const { return place[dof].node; }
    Dof dof(const unsigned int node, const unsigned int component) const
    {
      return nodes[node].dofs[component];
    }

    /** The unit vector (Cartesian) along which a degree of freedom moves its node. */
    dealii::Tensor<1, 3> direction(const Dof dof) const;

    /**
     * For each degree of freedom on the high cut of a whole sector that is not hanging in
     * @p hanging_nodes, its partner on the low cut.
     * @throws UserError if a node has no partner at the same (r, z).
     */
    std::vector<std::pair<Dof, Dof>>
    partners(const dealii::AffineConstraints<double> &hanging_nodes) const;

    /** The constraints of hanging nodes for a scalar with one value for each node, closed. */
    dealii::AffineConstraints<double>
    scalar_hanging_node_constraints(const dealii::DoFHandler<3> &dof_handler) const;

    /** From these, the constraints of the displacement in the axes used here, closed. */
    dealii::AffineConstraints<double>
    hanging_node_constraints(const dealii::AffineConstraints<double> &scalar) const;

    /** Turns a cell matrix from Cartesian components to the axes of the nodes. */
    void rotate_to_axes(const std::vector<Dof> &cell_dofs,
                        dealii::FullMatrix<double> &matrix) const;

    /** Turns a field from the axes of the nodes to Cartesian components. */
    void rotate_to_cartesian(dealii::Vector<double> &field) const;

    /** Fills a complex field, in the axes of the nodes, with a Cartesian displacement given at
     * points. */
    void
    interpolate(const std::function<std::array<std::complex<double>, 3>(const dealii::Point<3> &)>
                    &displacement,
                dealii::Vector<double> &real, dealii::Vector<double> &imaginary) const;

  private:
    struct Place
    {
      unsigned int node      = 0;
      unsigned int component = 0;
    };
    struct Node
    {
      std::array<Dof, 3> dofs;
      dealii::Point<3> position;
      dealii::types::boundary_id plane; ///< mirror, one of the cuts, or free
      /** Unit vectors of r and theta, where the node lies on a cut. */
      double cosine = 1., sine = 0.;
    };

    void collect(const dealii::DoFHandler<3> &dof_handler, const dealii::Mapping<3> &mapping);
    void mark(const dealii::DoFHandler<3> &dof_handler, const dealii::types::boundary_id boundary);
    void check_angle(const dealii::types::boundary_id boundary, const double angle,
                     const char *what) const;

    /** Throws a UserError if two partners are not apart by the pitch, in the right direction. */
    void check_turn(const Node &low, const Node &high) const;

    double pitch = 0.; ///< angle of a whole sector
    std::vector<Node> nodes;
    std::vector<Place> place; ///< of each degree of freedom
  };
} // namespace ringmotor
