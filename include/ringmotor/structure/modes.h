// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/cyclic_sector.h>
#include <ringmotor/structure/eigenpairs.h>

namespace ringmotor
{
  /** A free vibration of the cyclic body with a wave of `nodal_diameter` waves around the ring. */
  struct Mode
  {
    unsigned int nodal_diameter;
    double eigenvalue;         ///< omega^2 in 1/s^2
    bool rigid;                ///< a motion without strain
    ComplexField displacement; ///< M-normalised on the meshed part of the sector, in m/sqrt(kg)

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
   * Modes of a cyclic sector by shift-and-invert. One symbolic factorisation serves all nodal
   * diameters and shifts.
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
     * A shift (rad^2/s^2) such that the @p n_wanted elastic modes nearest to @p target (Hz; 0: the
     * lowest ones) lie below it with a wide gap above. Found on this, coarse, mesh, it serves finer
     * ones too.
     */
    double shift_above(const unsigned int k, const unsigned int n_wanted, const double target);

    /** The @p n_elastic lowest elastic modes of nodal diameter @p k and the rigid ones; not proven
     * complete. */
    std::vector<Mode> lowest(const unsigned int k, const unsigned int n_elastic);

    /** How many modes of nodal diameter @p k have an eigenvalue below @p shift. */
    unsigned int count_below(const unsigned int k, const double shift);

    /** Modes that below() has counted so far, and those it has found. */
    unsigned int n_counted() const { return counted; }
    unsigned int n_found() const { return found; }

  private:
    void factorise(const unsigned int k, const double shift);
    std::vector<Mode> solve(const unsigned int k, const double shift, const EigenvalueChoice choice,
                            const unsigned int count);

    const CyclicSector &sector;
    SparseLDLT factors;
    unsigned int counted = 0, found = 0;
  };
} // namespace ringmotor
