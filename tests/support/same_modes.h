// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/modes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ringmotor::tests
{
  /** The half and the whole sector of one free body have the same modes, up to the @p n_elastic
   * lowest elastic ones, for these nodal diameters; two are rigid for k = 0 and for k = 1. */
  inline void expect_same_modes(const CyclicSector &half, const CyclicSector &whole,
                                const std::vector<unsigned int> &nodal_diameters,
                                const unsigned int n_elastic)
  {
    ModeSolver half_solver(half), whole_solver(whole);
    for (const unsigned int k : nodal_diameters)
    {
      const double shift             = half_solver.shift_above(k, n_elastic, 0.);
      const std::vector<Mode> modes  = half_solver.below(k, shift),
                              others = whole_solver.below(k, shift);
      ASSERT_EQ(modes.size(), others.size());
      EXPECT_EQ(std::count_if(modes.begin(), modes.end(), [](const Mode &m) { return m.rigid; }),
                k < 2 ? 2 : 0);
      for (unsigned int i = 0; i < modes.size(); ++i)
      {
        EXPECT_EQ(modes[i].rigid, others[i].rigid);
        if (!modes[i].rigid)
        {
          EXPECT_NEAR(modes[i].eigenvalue / others[i].eigenvalue, 1., 1e-10) << k << " " << i;
        }
      }
    }
  }
} // namespace ringmotor::tests
