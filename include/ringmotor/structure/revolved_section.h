// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/sparse_ldlt.h>
#include <ringmotor/elements/semi_analytic.h>
#include <ringmotor/structure/cyclic_sector.h>
#include <ringmotor/structure/sector_factors.h>

#include <vector>

namespace ringmotor
{
  /**
   * The section of a body of revolution that moves in waves, U(r, z) exp(-i n theta) in cylindrical
   * components: waves of different orders n do not act on each other, so that each is a problem in
   * the half plane theta = 0, see WaveMatrices. Unknowns are those of the nodes there, the mirror
   * plane of a half sector; forces and masses are those of the half sector. For a mesh with one
   * layer of cells around.
   */
  class RevolvedSection
  {
  public:
    /** Whether a sector is part of a body of revolution, half of it is meshed with one layer of
     * cells around, and all of it is solids, shells and foundations that this class knows. */
    static bool describes(const SectorElements &sector);

    /** @p sector must outlive this object. */
    explicit RevolvedSection(const SectorElements &sector);

    unsigned int size() const { return n_unknowns; }

    /** Factorises K(n) - shift M, shift in rad^2/s^2. @throws ComputationError if it is singular */
    void factorise(const int order, const double shift);
    /** Number of eigenvalues below the shift. */
    unsigned int n_negative() const { return factors.n_negative(); }
    /** Replaces right-hand sides, one or several one after the other, by the solutions. */
    void solve(std::vector<double> &right_hand_sides) { factors.solve(right_hand_sides); }

    /** The product of the mass matrix and vectors of unknowns, one or several one after the other.
     */
    void multiply_mass(const std::vector<double> &unknowns, std::vector<double> &product) const;

    /** The load on the unknowns that does the work of @p load, which acts on nodes of the half
     * plane. */
    std::vector<double> loads_of(const LinearForm &load) const;

    /** The wave of this order given by the unknowns that begin at @p unknowns, at all nodes of the
     * half sector. */
    SectorMotion expand(const int order, const double *unknowns) const;

  private:
    using Dof = SectorNodes::Dof;
    /** Degrees of freedom of the half plane with the matrices for them. */
    struct Element
    {
      std::vector<unsigned int> rows;
      WaveMatrices matrices;
    };

    /** A displacement of a node to which one in the half plane contributes. */
    struct Copy
    {
      Dof to, from;
      unsigned int angle; ///< of the node, in #angles
      bool is_turned;     ///< see SectorNodes::turned_by_mirror()
      double weight;      ///< of the direction of one in that of the other
    };

    void add_solids();
    void add_shells();
    void add_foundations();
    /** Adds matrices per radian, with those degrees of freedom that depend on others condensed to
     * what they follow. */
    void add(const std::vector<Dof> &dofs, WaveMatrices matrices);
    void find_sources();
    /** Those of the nodes of a cell. */
    template <int dim>
    void find_sources(const dealii::FiniteElement<dim, 3> &fe, const unsigned int face,
                      const std::vector<Dof> &dofs);
    /** How waves continue from the half plane to all nodes. */
    void find_copies();
    /** Of a degree of freedom in the half plane that depends on no others. */
    unsigned int row_of(const Dof dof) const;

    const SectorElements &sector;
    const double meshed_angle;           ///< rad, of the part of the sector that is meshed
    const std::vector<unsigned int> row; ///< by degree of freedom; none if elsewhere or dependent
    const unsigned int n_unknowns;
    std::vector<unsigned int> source; ///< by node: that at the same place in the half plane
    std::vector<double> angles;       ///< rad, at which there are nodes
    std::vector<Copy> copies;
    std::vector<Element> elements;
    SparseLDLT factors;
  };
} // namespace ringmotor
