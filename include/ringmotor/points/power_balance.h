// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/curve_point.h>

#include <map>
#include <utility>

namespace ringmotor
{
  /** Which steps the balance of powers needs, as it has fallen with the steps so far. */
  class PowerBalance
  {
  public:
    /** @param most_parts of a step */
    explicit PowerBalance(const unsigned int most_parts) : most_parts(most_parts) {}

    /** The number of parts of a step that is expected to balance the powers of a point, found with
     * @p n_parts on a mesh: no more than that if they balance, or no shorter steps are tried.
     * @throws ComputationError if the imbalance falls so slowly that no step will do */
    unsigned int parts_for(const CurvePoint &point, const unsigned int level,
                           const unsigned int n_parts);

  private:
    /** @param excess imbalance over the largest admissible one */
    void foresee(const CurvePoint &point, const unsigned int level, const unsigned int n_parts,
                 const double excess);

    const unsigned int most_parts;
    /** Parts of a step and excess when that was first too large, by level and request. */
    std::map<std::pair<unsigned int, PointRequest>, std::pair<double, double>> first;
  };
} // namespace ringmotor
