// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/friction.h>
#include <ringmotor/contact/solve/contact_problem.h>

#include <vector>

namespace ringmotor
{
  /** Coefficients of friction that follow from the slips of another state: in a chain of problems,
   * each problem has those of the solution of the previous one. */
  class GivenCoefficients
  {
  public:
    /** For points that slip as in @p motion, or do not slip if that is empty. The memory of the
     * points, on which the law depends, may change later. */
    GivenCoefficients(const PointFriction &law, const unsigned int n_points,
                      const std::vector<PointVector> &motion = {});

    double operator[](const unsigned int point) const { return coefficients[point]; }

    /** Takes the coefficients of a state and its motion. @return their largest change at pressed
     * points, relative to the new ones */
    double update(const ContactState &state, const std::vector<PointVector> &motion);

  private:
    const PointFriction law;
    std::vector<double> coefficients;
  };
} // namespace ringmotor
