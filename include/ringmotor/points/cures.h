// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <set>

namespace ringmotor
{
  /** What makes the errors of an operating point smaller, in the order of its price. */
  enum class Cure
  {
    steps, ///< shorter ones, of this point alone
    modes, ///< more, on a finer mesh: all points anew
    meshes ///< finer ones: all points anew, each several times as dear
  };

  /**
   * The cheapest cures that are expected to suffice, taken once; where none do, the cheapest that
   * may suffice if they are taken again.
   * @param curable squares of the relative errors that they make smaller
   * @param incurable that of all other errors of the point
   * @param target square of the relative error that it may have
   * @return none if @p incurable exceeds the target or nothing is curable
   */
  std::set<Cure> cheapest_cures(const std::map<Cure, double> &curable, const double incurable,
                                const double target);
} // namespace ringmotor
