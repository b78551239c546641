// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_problem.h>
#include <ringmotor/contact/friction.h>

#include <vector>

namespace ringmotor
{
  /** Coefficients of friction by the slips of another state: of the last problem of a chain, in
   * which each problem has those that belong to the one before. */
  class GivenCoefficients
  {
  public:
    /** Of points that slip as in @p motion, or do not slip if that is empty. The law may change
     * what it remembers of points. */
    GivenCoefficients(const PointFriction &law, const unsigned int n_points,
                      const std::vector<PointVector> &motion = {});

    double operator[](const unsigned int point) const { return coefficients[point]; }

    /** Takes those that belong to a state and its motion. @return how much they change at most, of
     * points that are pressed, relative to the new ones */
    double update(const ContactState &state, const std::vector<PointVector> &motion);

  private:
    const PointFriction law;
    std::vector<double> coefficients;
  };
} // namespace ringmotor
