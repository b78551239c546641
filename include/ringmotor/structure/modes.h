// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/eigenpairs.h>
#include <ringmotor/structure/cyclic_factors.h>

#include <map>
#include <vector>

namespace ringmotor
{
  /** A free vibration of the cyclic body with a wave of `nodal_diameter` waves around the ring. */
  struct Mode
  {
    unsigned int nodal_diameter;
    double eigenvalue;   ///< omega^2 in 1/s^2
    bool rigid;          ///< a motion without strain
    SectorMotion motion; ///< M-normalised on the meshed part of the sector, in m/sqrt(kg)

    /** Relative difference between the eigensolver's eigenvalue and that from the energies of the
     * mode. */
    double algebra_error = 0.;

    /** Natural frequency in Hz. */
    double frequency() const;
  };

  /**
   * The @p n_wanted elastic modes of @p modes nearest to @p target (Hz; 0: the lowest), sorted by
   * frequency.
   */
  std::vector<Mode> nearest_elastic(const std::vector<Mode> &modes, const unsigned int n_wanted,
                                    const double target);

  /**
   * Replaces the eigenvalues by Rayleigh quotients from the strains, which rounding errors of a
   * large rigid motion barely affect. In the assembled stiffness they blur the eigenvalues of slow
   * modes.
   */
  void sharpen_eigenvalues(const CyclicSector &sector, std::vector<Mode> &modes);

  /** Shifts (rad^2/s^2) between two eigenvalues, well away from both. */
  struct ShiftWindow
  {
    double low, high;
  };

  /**
   * For each nodal diameter a shift in one of its @p windows, chosen such that few different shifts
   * are needed: nodal diameters with the same shift share a factorisation.
   */
  std::map<unsigned int, double>
  common_shifts(const std::map<unsigned int, std::vector<ShiftWindow>> &windows);

  /**
   * Modes of a cyclic sector by shift-and-invert. Calls with the same shift, whatever the nodal
   * diameter, share one sparse factorisation.
   */
  class ModeSolver
  {
  public:
    /** @p sector must outlive this object. */
    explicit ModeSolver(const CyclicSector &sector);

    /**
     * All modes of nodal diameter @p k with an eigenvalue below @p shift (rad^2/s^2), rigid ones
     * included, sorted. Complete by Sturm count: as many as the factorisation has negative pivots.
     * @throws ComputationError if fewer are found.
     */
    std::vector<Mode> below(const unsigned int k, const double shift);

    /**
     * Shifts above the @p n_wanted elastic modes nearest to @p target (Hz; 0: the lowest ones), but
     * below few others. Shifts found on a coarse mesh can be used on finer ones.
     */
    std::vector<ShiftWindow> windows_above(const unsigned int k, const unsigned int n_wanted,
                                           const double target);

    /** The middle of the widest of these windows. */
    double shift_above(const unsigned int k, const unsigned int n_wanted, const double target);

    /** The @p n_elastic lowest elastic modes of nodal diameter @p k and the rigid ones; not
     * verified to be complete. */
    std::vector<Mode> lowest(const unsigned int k, const unsigned int n_elastic);

    /** How many modes of nodal diameter @p k have an eigenvalue below @p shift. */
    unsigned int count_below(const unsigned int k, const double shift);

    /** Modes that below() has counted so far, and those it has found. */
    unsigned int n_counted() const { return counted; }
    unsigned int n_found() const { return found; }

  private:
    std::vector<Mode> solve(const unsigned int k, const double shift, const EigenvalueChoice choice,
                            const unsigned int count);

    const CyclicSector &sector;
    CyclicFactors factors;
    unsigned int counted = 0, found = 0;
  };
} // namespace ringmotor
