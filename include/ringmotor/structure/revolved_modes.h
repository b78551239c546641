// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/modes.h>
#include <ringmotor/structure/revolved_section.h>

#include <vector>

namespace ringmotor
{
  /**
   * The vibrations of a body of revolution by the nodal diameters k of its N sectors. Each is found
   * by itself from waves of the orders n = k + j N for whole numbers j, which sectors see as the
   * same, up to |n| = p N / 2: between the nodes of the sector, polynomials of degree p cannot
   * follow higher ones.
   */
  class RevolvedModes
  {
  public:
    /** @p sector, which RevolvedSection describes, must outlive this object. */
    explicit RevolvedModes(const CyclicSector &sector);

    /** The orders of nodal diameter @p k, the lowest first; without negative ones that are
     * conjugate to others of the same nodal diameter. */
    std::vector<int> orders(const unsigned int k) const;

    /** See response_vectors(). @param loads in the half plane theta = 0, each of them as the wave
     * of each order @param highest see without_fast_vectors() */
    std::vector<Mode> responses(const unsigned int k, const std::vector<LinearForm> &loads,
                                const std::vector<double> &frequencies, const double highest);

    /** All modes of nodal diameter @p k below a shift (rad^2/s^2), see ModeSolver::below(). Of a
     * body without rigid motions of that nodal diameter. */
    std::vector<Mode> below(const unsigned int k, const double shift);

  private:
    /** Whether orders n and -n belong to this nodal diameter. */
    bool has_conjugates(const unsigned int k) const;
    bool is_conjugate(const unsigned int k, const int order) const;
    /** With its conjugate, if that is of the same nodal diameter. */
    void add(const unsigned int k, const int order, const double eigenvalue, const double *unknowns,
             std::vector<Mode> &modes) const;

    const CyclicSector &sector;
    RevolvedSection section;
  };
} // namespace ringmotor
