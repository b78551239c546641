// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/structure/potential_dofs.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <complex>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ringmotor
{
  /** A node whose value follows those of other nodes: the sum of weight * value over its masters,
   * in Cartesian components. */
  struct SlaveNode
  {
    unsigned int node;
    std::vector<std::pair<unsigned int, dealii::Tensor<2, 3>>> masters;
    dealii::Tensor<1, 3> free_direction; ///< the part of the value along it is free, unless zero
  };

  /** How a body moves at a node: displacement in m and, where there is a shell, rotation in rad;
   * Cartesian components. */
  struct NodeMotion
  {
    std::array<std::complex<double>, 3> displacement, rotation;
  };

  /**
   * The nodes of the solids (FE_Q with three components), of the shells (with six) and of the
   * electric potential (with one) of a sector, in one numbering of degrees of freedom, in this
   * order. A node has three degrees of freedom that belong together, a displacement or a rotation
   * of the shell, or one, a potential. It stores whether it lies on the mirror plane or on a cut,
   * and the axes used there. On a cut the degrees of freedom of a node are its (r, theta, z)
   * components, elsewhere (x, y, z).
   */
  class SectorNodes
  {
  public:
    using Dof = dealii::types::global_dof_index;

    /** Without nodes, to be assigned to. */
    SectorNodes() = default;

    /**
     * Finds the nodes of @p solid and @p shell; one of them may have none.
     * @throws UserError if the mirror plane is not theta = 0, the half sector's cut is not
     *         theta = alpha/2, or such faces are missing.
     */
    SectorNodes(const dealii::DoFHandler<3> &solid, const dealii::Mapping<3> &mapping,
                const dealii::DoFHandler<2, 3> &shell, const dealii::Mapping<2, 3> &shell_mapping,
                const PotentialDofs &potentials, const SectorMesh &mesh);

    /** All degrees of freedom. */
    unsigned int n_dofs() const { return place.size(); }

    /** The number of the shell's first degree of freedom. */
    unsigned int first_shell_dof() const { return n_solid_dofs; }

    /** That of the first potential. */
    unsigned int first_potential_dof() const { return n_mechanical_dofs; }
    bool is_potential(const Dof dof) const { return dof >= n_mechanical_dofs; }

    /** True if the node of @p dof lies on a face with this boundary id (mirror or one of the cuts).
     */
    bool on(const Dof dof, const dealii::types::boundary_id boundary) const;

    /** 0, 1, 2 for x, y, z or, on a cut, for r, theta, z; 0 for a potential. */
    unsigned int component(const Dof dof) const { return place[dof].component; }

    /** Whether the mirror theta -> -theta reverses the component: the theta component of a
     * displacement, r and z components of a rotation. */
    bool turned_by_mirror(const Dof dof) const
    {
      return (place[dof].component == 1) != (nodes[place[dof].node].kind == Kind::rotation);
    }

    unsigned int size() const { return nodes.size(); }

    /** The node of a degree of freedom, and back. */
    unsigned int node(const Dof dof) const { return place[dof].node; }
    Dof dof(const unsigned int node, const unsigned int component) const
    {
      return nodes[node].dofs[component];
    }

    const dealii::Point<3> &position(const unsigned int node) const { return nodes[node].position; }

    /** The number of degrees of freedom of a node: three, or one of a potential. */
    unsigned int n_components(const unsigned int node) const { return nodes[node].n_dofs(); }

    /** The unit vector (Cartesian) along which a degree of freedom moves its node; zero for a
     * potential. */
    dealii::Tensor<1, 3> direction(const Dof dof) const;

    /**
     * For each degree of freedom on the high cut of a whole sector that is not hanging in
     * @p dependent, its partner on the low cut.
     * @throws UserError if a node has no partner at the same (r, z).
     */
    std::vector<std::pair<Dof, Dof>>
    partners(const dealii::AffineConstraints<double> &dependent) const;

    /** The constraints of hanging nodes for a scalar with one value for each node, closed. */
    dealii::AffineConstraints<double>
    scalar_hanging_node_constraints(const dealii::DoFHandler<3> &solid,
                                    const PotentialDofs &potentials) const;

    /** The same as constraints on vectors. */
    static std::vector<SlaveNode>
    slaves_of(const dealii::AffineConstraints<double> &scalar_hanging_nodes);

    /** The constraints that make @p slaves follow their masters, in the axes used here, closed. */
    dealii::AffineConstraints<double> constraints(const std::vector<SlaveNode> &slaves) const;

    /** Rotates a cell matrix from Cartesian components to the axes of the nodes. */
    void rotate_to_axes(const std::vector<Dof> &cell_dofs,
                        dealii::FullMatrix<double> &matrix) const;

    /** Rotates a field from Cartesian components to the axes of the nodes. */
    void rotate_to_axes(dealii::Vector<double> &field) const;

    /** Rotates a field from the axes of the nodes to Cartesian components. */
    void rotate_to_cartesian(dealii::Vector<double> &field) const;

    /** Fills a complex field, in the axes of the nodes, with a motion given as a function of
     * position. */
    void interpolate(const std::function<NodeMotion(const dealii::Point<3> &)> &motion,
                     dealii::Vector<double> &real, dealii::Vector<double> &imaginary) const;

  private:
    struct Place
    {
      unsigned int node      = 0;
      unsigned int component = 0;
    };
    enum class Kind
    {
      displacement,
      rotation, ///< of a shell
      potential
    };
    struct Node
    {
      std::array<Dof, 3> dofs; ///< the first one only for a potential
      dealii::Point<3> position;
      dealii::types::boundary_id plane; ///< mirror, one of the cuts, or free
      Kind kind;
      /** Unit vectors of r and theta, where the node lies on a cut. */
      double cosine = 1., sine = 0.;

      unsigned int n_dofs() const { return kind == Kind::potential ? 1 : 3; }
      /** Whether its axes are not x, y, z. */
      bool is_turned() const { return kind != Kind::potential && sine != 0.; }
    };

    template <int dim>
    void collect(const dealii::DoFHandler<dim, 3> &dof_handler,
                 const dealii::Mapping<dim, 3> &mapping, const Dof first_dof);
    /** Returns whether there are faces with this id. */
    template <int dim>
    bool mark(const dealii::DoFHandler<dim, 3> &dof_handler,
              const dealii::types::boundary_id boundary, const Dof first_dof);
    void collect(const PotentialDofs &potentials, const SectorMesh &mesh,
                 const dealii::Mapping<3> &mapping);
    void mark(const PotentialDofs &potentials, const SectorMesh &mesh,
              const dealii::types::boundary_id boundary);
    void add_constraints(const SlaveNode &slave,
                         dealii::AffineConstraints<double> &constraints) const;
    void check_angle(const dealii::types::boundary_id boundary, const double angle,
                     const char *what) const;

    /** Throws a UserError if two partners are not one pitch apart, in the right direction. */
    void check_turn(const Node &low, const Node &high) const;

    double pitch              = 0.; ///< angle of a whole sector
    unsigned int n_solid_dofs = 0, n_mechanical_dofs = 0;
    std::vector<Node> nodes;
    std::vector<Place> place; ///< of each degree of freedom
  };
} // namespace ringmotor
