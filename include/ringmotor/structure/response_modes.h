// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/cyclic_factors.h>
#include <ringmotor/structure/modes.h>

#include <functional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** Motions of a body that have one symmetry, by unknowns. */
  struct SymmetricMotions
  {
    std::size_t size;
    std::string name; ///< of the symmetry, for messages where the solution fails
    /** Replaces loads, one or several one after the other, by the motions under them: with the
     * stiffness reduced by a shift (rad^2/s^2) times the mass. */
    std::function<void(const double, std::vector<double> &)> solve;
    /** The second argument becomes the mass times the first. */
    std::function<void(const std::vector<double> &, std::vector<double> &)> multiply_mass;
  };

  /** Vectors of unknowns of unit mass that are orthogonal with respect to stiffness and mass. */
  struct RitzVectors
  {
    std::vector<double> values;  ///< rad^2/s^2, ascending: stiffness
    std::vector<double> vectors; ///< one after the other
  };

  /**
   * Vibrations that reproduce the response to given loads, at rest and at given frequencies. The
   * response to a force is the sum of those of all modes; those far above its frequency contribute,
   * too, and at high frequencies they are too many. The Ritz vectors of the space that the
   * responses at these frequencies span need no others: they give the response to the loads exactly
   * at these frequencies, and between them with an error of higher order (rational Krylov method;
   * Ruhe 1984). Those that have converged are modes, the others stand for all that are left out.
   *
   * @param loads on the unknowns (N)
   * @param frequencies rad/s, in addition to rest
   * @return at most as many as loads, at rest and at each frequency
   * @throws ComputationError if the solver fails, or finds resonance wherever it looks
   */
  RitzVectors response_vectors(const SymmetricMotions &body,
                               const std::vector<std::vector<double>> &loads,
                               const std::vector<double> &frequencies);

  /** Those of a cyclic sector. */
  class ResponseModes
  {
  public:
    /** @p sector must outlive this object, and must not move freely as a whole. */
    explicit ResponseModes(const CyclicSector &sector);

    /** See response_vectors(). @param loads of nodal diameter @p k */
    std::vector<Mode> at(const unsigned int k, const std::vector<std::vector<double>> &loads,
                         const std::vector<double> &frequencies);

  private:
    const CyclicSector &sector;
    CyclicFactors at_rest, at_frequency; ///< what does not depend on k is computed once at rest
  };

  /** Without the vectors far above a @p frequency (rad/s). Up to a ninth they respond as at rest;
   * with inertia they would be little more than masses of the loaded surface, and colliding masses
   * lose energy in finite steps. */
  std::vector<Mode> without_fast_vectors(std::vector<Mode> modes, const double frequency);
  /** Whether one with a stiffness (rad^2/s^2, for unit mass) would be left out there. */
  bool is_fast(const double eigenvalue, const double frequency);
} // namespace ringmotor
