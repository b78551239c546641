// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace ringmotor
{
  /** How finely two bodies are meshed where they touch. */
  struct InterfaceGrading
  {
    unsigned int n_across = 1; ///< cells across the lip
    unsigned int n_around = 1; ///< cells along the half tooth, or along the lip's half pitch
    /** Of the distances of successive mesh lines from an edge. The stresses at the edges of contact
     * are singular, for which such layers of cells converge exponentially (Schwab 1998: the best
     * ratio is 0.15); 1: even cells, which do not. */
    double ratio           = 0.15;
    unsigned int n_at_foot = 1; ///< layers of the tooth that shrink towards its foot

    bool operator==(const InterfaceGrading &other) const
    {
      return n_across == other.n_across && n_around == other.n_around && ratio == other.ratio &&
             n_at_foot == other.n_at_foot;
    }
  };

  /** Lines of @p n_cells cells, at distances 0 to @p length (m) from an edge; successive distances
   * have the given @p ratio, or differ by the same length if it is 1. */
  std::vector<double> lines_from_edge(const double length, const unsigned int n_cells,
                                      const double ratio);
} // namespace ringmotor
