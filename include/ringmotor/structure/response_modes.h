// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/cyclic_factors.h>
#include <ringmotor/structure/modes.h>

#include <vector>

namespace ringmotor
{
  /**
   * Vibrations of a cyclic sector that reproduce its response to given loads, at rest and at given
   * frequencies. The response to a force is the sum of those of all modes; those far above its
   * frequency contribute, too, and at high frequencies they are too many. The Ritz vectors of the
   * space that the responses at these frequencies span need no others: they give the response to
   * the loads exactly at these frequencies, and between them with an error of higher order
   * (rational Krylov method; Ruhe 1984). Those that have converged are modes, the others stand for
   * all that are left out.
   */
  class ResponseModes
  {
  public:
    /** @p sector must outlive this object, and must not move freely as a whole. */
    explicit ResponseModes(const CyclicSector &sector);

    /**
     * @param loads of nodal diameter @p k, on the unknowns (N)
     * @param frequencies rad/s, in addition to rest
     * @return Ritz vectors, sorted; at most as many as loads, at rest and at each frequency
     * @throws ComputationError if the solver fails, or finds resonance wherever it looks
     */
    std::vector<Mode> at(const unsigned int k, const std::vector<std::vector<double>> &loads,
                         const std::vector<double> &frequencies);

  private:
    struct Response
    {
      double frequency;            ///< rad/s
      std::vector<double> motions; ///< one after the other
    };
    Response response(const unsigned int k, const std::vector<double> &loads,
                      const double frequency);
    /** At a frequency, or next to it if that is a resonance. */
    Response beside_resonance(const unsigned int k, const std::vector<double> &loads,
                              const double frequency, const Response &rest);

    const CyclicSector &sector;
    CyclicFactors at_rest, at_frequency; ///< what does not depend on k is computed once at rest
  };

  /** Without the vectors far above a @p frequency (rad/s). Up to a ninth they respond as at rest;
   * with inertia they would be little more than masses of the loaded surface, and colliding masses
   * lose energy in finite steps. */
  std::vector<Mode> without_fast_vectors(std::vector<Mode> modes, const double frequency);
} // namespace ringmotor
