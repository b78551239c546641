// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/sparse_ldlt.h>
#include <ringmotor/structure/cyclic_sector.h>
#include <ringmotor/structure/sector_stiffness.h>

#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace ringmotor
{
  /** The factorised K - shift M of both fields of a nodal diameter in all their unknowns. */
  class JointFactors
  {
  public:
    /** @p sector must outlive this object. */
    explicit JointFactors(const CyclicSector &sector);

    /** Factorises for a nodal diameter and a shift (rad^2/s^2). @throws ComputationError if the
     * matrix is singular */
    void factorise(const unsigned int k, const double shift);

    /** Number of negative eigenvalues of the matrix, written in real numbers. */
    unsigned int n_negative() const
    {
      return sector.n_fields() * stiffness.n_negative() + sparse.n_negative();
    }

    /** Replaces right-hand sides, one or several one after the other, by the solutions. */
    void solve(std::vector<double> &right_hand_sides);

  private:
    /** Unknowns with the factors by which a degree of freedom of a field follows them. */
    using Sum = std::vector<std::pair<unsigned int, double>>;

    void follow_unknowns(const unsigned int k);
    /** Adds an element of one field, in the rows of the sparse matrix. */
    void add(const SectorStiffness::Element &element, const unsigned int part,
             SymmetricElements &elements) const;

    const CyclicSector &sector;
    SectorStiffness stiffness;
    std::vector<unsigned int> row; ///< of the sparse matrix, by unknown; none if inside a cell
    SparseLDLT sparse;
    std::array<std::vector<Sum>, 2> follows; ///< by field and degree of freedom
    double computed_shift = std::numeric_limits<double>::quiet_NaN();
  };
} // namespace ringmotor
