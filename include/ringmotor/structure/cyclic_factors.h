// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/dense_ldlt.h>
#include <ringmotor/structure/joint_factors.h>
#include <ringmotor/structure/sector_factors.h>

#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace ringmotor
{
  /**
   * The factorised K - shift M of a cyclic sector. The two real fields are coupled only at the cut,
   * and only there does the nodal diameter matter: one factorisation down to the cut serves all
   * nodal diameters, and each of these adds a small dense one. Where much of the body lies on its
   * cuts, as with a ring without teeth, the dense matrices would be large: there (and where there
   * is no cut), each nodal diameter gets a sparse factorisation of both fields together.
   */
  class CyclicFactors
  {
  public:
    /** @p sector must outlive this object. */
    explicit CyclicFactors(const CyclicSector &sector);

    /**
     * Factorises for a shift (rad^2/s^2) and a nodal diameter. Cheap while the shift is unchanged.
     * @throws ComputationError if the matrix is singular.
     */
    void factorise(const unsigned int k, const double shift);

    /** Number of negative eigenvalues of the matrix, written in real numbers. */
    unsigned int n_negative() const;

    /** Replaces right-hand sides, one or several one after the other, by the solutions (on all
     * ranks). Several together take a fraction of the time. */
    void solve(std::vector<double> &right_hand_sides);

  private:
    void factorise_cut(const unsigned int k);

    const CyclicSector &sector;
    std::unique_ptr<JointFactors> joint;    ///< null if the cut is small
    std::unique_ptr<SectorFactors> inside;  ///< down to the cut; null if it is large
    std::vector<unsigned int> cut_unknowns; ///< in the order of the dense matrix
    std::vector<unsigned int> cut_place;    ///< the inverse, by unknown
    std::array<std::vector<CyclicSector::Tie>, 2> ties;
    DenseLDLT cut;
    double factorised_shift = std::numeric_limits<double>::quiet_NaN();
  };
} // namespace ringmotor
