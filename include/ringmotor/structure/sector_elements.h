// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/elements/bar.h>
#include <ringmotor/elements/foundation.h>
#include <ringmotor/elements/shell.h>
#include <ringmotor/elements/solid.h>
#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/structure/sector_nodes.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <complex>
#include <functional>
#include <map>
#include <vector>

namespace ringmotor
{
  /** A complex amplitude U = real + i imaginary on a mesh of the sector, in Cartesian components.
   */
  struct ComplexField
  {
    dealii::Vector<double> real, imaginary;
  };

  /** How the sector moves: displacements (m) of the solids, and of the shells' reference surfaces
   * with their rotations (rad); with the electric potential (V) of piezoelectric solids. */
  struct SectorMotion
  {
    ComplexField solid, shell, potential;

    /** Its fields in the order of the degrees of freedom of a sector. */
    std::array<ComplexField *, 3> parts() { return {{&solid, &shell, &potential}}; }
    std::array<const ComplexField *, 3> parts() const { return {{&solid, &shell, &potential}}; }

    /** Scales the motion and shifts its phase. */
    SectorMotion &operator*=(const std::complex<double> factor);
  };

  /** What is prescribed on the lower electrode of a piezoelectric layer. */
  enum class LowerElectrode
  {
    grounded, ///< zero potential: modes at short circuit
    driven    ///< nothing: its potential is among the unknowns
  };

  /**
   * The solids, shells, bars and foundations of a sector in finite elements of one degree: their
   * degrees of freedom in one numbering, those of the shell after those of the solids, then those
   * of the potential, and the constraints among them that do not depend on the wave. The potential
   * is zero on grounded electrodes.
   */
  class SectorElements
  {
  public:
    using Dof       = SectorNodes::Dof;
    using Cell      = dealii::DoFHandler<3>::active_cell_iterator;
    using ShellCell = dealii::DoFHandler<2, 3>::active_cell_iterator;

    /**
     * Numbers @p mesh with FE_Q(@p degree) for each component of displacement and rotation. The
     * mesh must outlive this object.
     * @throws UserError if the cuts do not match or the mirror and cut faces are not where they
     * belong.
     */
    SectorElements(const SectorMesh &mesh, const MaterialTable &materials,
                   const unsigned int degree,
                   const LowerElectrode lower_electrode = LowerElectrode::grounded);

    /** All degrees of freedom. */
    unsigned int n_dofs() const { return sector_nodes.n_dofs(); }
    /** Those that this rank owns. */
    dealii::IndexSet owned_dofs() const;

    const SectorNodes &nodes() const { return sector_nodes; }
    /** Hanging-node constraints of the solids, for a scalar with one value per node. */
    const dealii::AffineConstraints<double> &scalar_hanging_nodes() const { return hanging; }
    /** Hanging nodes, ties between solids and shells, clamped faces, electrodes; in the axes of the
     * nodes. */
    const dealii::AffineConstraints<double> &dependent() const { return dependent_dofs; }
    /** Whether some of these degrees of freedom follow a shell. */
    bool are_tied(const std::vector<Dof> &dofs) const;

    /** The degrees of freedom of a cell in the order of its element. */
    std::vector<Dof> dofs_of(const Cell &cell) const;
    std::vector<Dof> dofs_of(const ShellCell &cell) const;
    /** Whether a cell has a potential, and its degrees of freedom in the order of FE_Q. */
    bool has_potential(const Cell &cell) const { return potentials.are_on(cell); }
    std::vector<Dof> potential_dofs_of(const Cell &cell) const;
    /** Those of the potential on the driven electrode, the lower one. */
    std::vector<Dof> electrode_dofs() const;
    /** Those of the edge of a cell that carries a bar, in the order of its element. */
    std::vector<Dof> dofs_on(const Cell &cell, const BarElement &bar) const;

    /** Visits the solid cells that this rank owns, with the element reinitialized there. */
    void for_each_owned_cell(const std::function<void(const Cell &, SolidElement &)> &visit) const;
    /** The same for shell cells. */
    void for_each_owned_shell_cell(
        const std::function<void(const ShellCell &, ShellElement &)> &visit) const;
    /** The same for the edges with bars: one of their cells, their boundary id and the element. */
    void for_each_owned_bar(const std::function<void(const Cell &, const dealii::types::boundary_id,
                                                     BarElement &)> &visit) const;
    /** The same for the faces on a foundation: their cell, their boundary id and the element. */
    void for_each_owned_foundation(
        const std::function<void(const Cell &, const dealii::types::boundary_id,
                                 FoundationElement &)> &visit) const;

    /** Fields in the axes of the nodes, with dependent degrees of freedom still zero, as a motion.
     */
    SectorMotion to_motion(std::array<dealii::Vector<double>, 2> fields) const;

    /** A motion of all degrees of freedom in the axes of the nodes. */
    std::array<dealii::Vector<double>, 2> in_axes(const SectorMotion &motion) const;

    /** The transpose of to_motion(): forces on all degrees of freedom become forces on those that
     * are not dependent, in the axes of the nodes. */
    std::array<dealii::Vector<double>, 2> from_forces(const SectorMotion &forces) const;

    /** A zero motion. */
    SectorMotion at_rest() const;

    const dealii::DoFHandler<3> &dofs() const { return dof_handler; }
    const dealii::Mapping<3> &geometry() const { return mapping; }
    /** Six components, displacement and rotation; without active degrees of freedom if there is no
     * shell. */
    const dealii::DoFHandler<2, 3> &shell_dofs() const { return shell_dof_handler; }
    const dealii::Mapping<2, 3> &shell_geometry() const { return shell_mapping; }
    const SectorMesh &sector_mesh() const { return mesh; }
    const MaterialTable &material_table() const { return materials; }
    MPI_Comm communicator() const { return mesh.triangulation->get_communicator(); }

  private:
    void constrain(const LowerElectrode lower_electrode);

    const SectorMesh &mesh;
    const MaterialTable materials;
    const dealii::MappingQ<3> mapping;
    const dealii::FESystem<3> fe;
    dealii::DoFHandler<3> dof_handler;
    const dealii::MappingQ<2, 3> shell_mapping;
    const dealii::FESystem<2, 3> shell_fe;
    dealii::DoFHandler<2, 3> shell_dof_handler;

    PotentialDofs potentials;

    SectorNodes sector_nodes;
    dealii::AffineConstraints<double> hanging, dependent_dofs;
    std::vector<bool> tied; ///< by node
  };
} // namespace ringmotor
