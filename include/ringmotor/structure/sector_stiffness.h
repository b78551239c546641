// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/dense_ldlt.h>
#include <ringmotor/structure/sector_elements.h>

#include <algorithm>
#include <vector>

namespace ringmotor
{
  /**
   * The dynamic stiffness K - shift M of a sector, with no condition on the mirror plane or the
   * cuts, as the sum of small matrices: those of cells, bars and foundations, in the axes of the
   * nodes and in degrees of freedom that do not depend on others. The inner degrees of freedom of a
   * cell meet no other cell and are eliminated in it. In piezoelectric cells the potential is among
   * the degrees of freedom, and the matrix is indefinite: (K - shift M, B; B^T, -D), see
   * SolidElement.
   */
  class SectorStiffness
  {
  public:
    using Dof = SectorNodes::Dof;

    /** The share of a cell, a bar or a foundation. */
    struct Element
    {
      std::vector<Dof> dofs;
      std::vector<double> lower; ///< triangle of the symmetric matrix, by columns

      double operator()(const std::size_t i, const std::size_t j) const
      {
        const std::size_t row = std::max(i, j), column = std::min(i, j);
        return lower[column * dofs.size() - column * (column + 1) / 2 + row];
      }
    };

    /** @param stays by degree of freedom, those that must not be eliminated
     *
     * @p elements must outlive this object. */
    SectorStiffness(const SectorElements &elements, const std::vector<bool> &stays);

    /** Whether a degree of freedom is eliminated in its cell. */
    bool is_inner(const Dof dof) const { return inner[dof]; }

    /** Computes the elements for a shift (rad^2/s^2). @throws ComputationError if the inside of a
     * cell is in resonance */
    void compute(const double shift);

    /** Those of this rank. */
    const std::vector<Element> &elements() const { return own; }
    /** Frees their memory; the rest of this object stays as it is. */
    void forget_elements() { own.clear(); }

    /** Number of negative eigenvalues of the inner degrees of freedom, over all ranks. */
    unsigned int n_negative() const;

    /** Adds to loads on all degrees of freedom, one or several vectors one after the other (the
     * same on all ranks), what those on the inner ones leave to the others. */
    void condense(std::vector<double> &loads) const;

    /** Replaces the inner degrees of freedom in @p motions by those that follow from the others and
     * from @p loads, several as above. */
    void expand(const std::vector<double> &loads, std::vector<double> &motions);

  private:
    /** A cell whose inner degrees of freedom are eliminated. */
    struct Cell
    {
      std::vector<Dof> inner, outer;
      DenseLDLT factors;            ///< of the inner block
      std::vector<double> response; ///< of the inner ones to the outer ones, minus; by columns
    };

    /** Adds an element with a matrix in Cartesian components; the last @p n_inner of @p dofs are
     * eliminated. */
    void add(std::vector<Dof> dofs, const unsigned int n_inner, dealii::FullMatrix<double> &matrix);
    void add_foundations();
    /** The share of a cell with a potential. */
    void add_piezoelectric(const SectorElements::Cell &cell, SolidElement &element,
                           const double shift);
    /** What remains of an element when its last @p n_inner degrees of freedom are eliminated. */
    Element eliminate(const std::vector<Dof> &dofs, const unsigned int n_inner,
                      const dealii::FullMatrix<double> &matrix);
    /** Inner degrees of freedom of a cell, which are its last ones. */
    unsigned int n_inner(const std::vector<Dof> &dofs) const;

    const SectorElements &all;
    std::vector<bool> inner; ///< by degree of freedom
    std::vector<Element> own;
    std::vector<Cell> cells;
  };
} // namespace ringmotor
