// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/joint_factors.h>
#include <ringmotor/structure/modes.h>

#include <optional>
#include <vector>

namespace ringmotor
{
  /**
   * Modes of a whole ring, whose symmetry need not be known: by shift-and-invert with a sparse
   * factorisation (MUMPS), and block by block, as a ring of equal sectors has most eigenvalues
   * twice. Nodal diameters of the modes are not set.
   */
  class RingSolver
  {
  public:
    /** @param ring its form is SectorForm::ring. It must outlive this object. */
    explicit RingSolver(const CyclicSector &ring);

    /**
     * Shifts in gaps of the spectrum around the @p n_wanted elastic modes nearest to @p target (Hz;
     * 0: the lowest ones). No gap is between two eigenvalues of a pair, so that more modes may lie
     * between the shifts. Those found on a coarse mesh can be used on finer ones.
     * @throws ComputationError if there are no such gaps
     */
    ShiftWindow window_around(const unsigned int n_wanted, const double target);

    /**
     * All modes with eigenvalues between two shifts (rad^2/s^2), sorted, rigid ones left out.
     * Complete by Sturm counts at both of them.
     * @throws ComputationError if fewer are found
     */
    std::vector<Mode> between(const ShiftWindow &shifts);

    /** Modes that between() has counted last, and those it has found. */
    unsigned int n_counted() const { return counted; }
    unsigned int n_found() const { return found; }

  private:
    /** The number of eigenvalues below a shift, which the factors then belong to. */
    unsigned int count_below(const double shift);
    /** The window in the eigenpairs nearest to a target, if they reach beyond it on both sides.
     * @param has_lowest whether all below the target are among them */
    std::optional<ShiftWindow> window_in(const std::vector<Eigenpair> &pairs,
                                         const unsigned int n_wanted, const double target,
                                         const bool has_lowest) const;
    std::vector<Eigenpair> pairs(const double shift, const EigenvalueChoice choice,
                                 const unsigned int count, const double residual);

    const CyclicSector &ring;
    const double slow; ///< eigenvalue below which a motion is rigid
    JointFactors factors;
    unsigned int counted = 0, found = 0;
  };
} // namespace ringmotor
