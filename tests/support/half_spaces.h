// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "support/dense_contact.h"

#include <array>
#include <cmath>
#include <vector>

namespace ringmotor::tests
{
  /**
   * A sphere of @p radius (m) pressed on a plane of the same material and shifted along t, as
   * elastic half-spaces in squares of side @p width (m). A quarter suffices: pressure and friction
   * along t are even about both axes, friction across t is odd.
   */
  struct SphereOnPlane
  {
    double shear_modulus, poisson_ratio, radius, width;
    double reach; ///< m, squares whose middle is farther from the axis cannot touch

    double area() const { return width * width; }

    /** Middles of the squares of the quarter. */
    std::vector<std::array<double, 2>> points() const
    {
      std::vector<std::array<double, 2>> points;
      for (double x = 0.5 * width; x < reach; x += width)
        for (double y = 0.5 * width; y < reach; y += width)
          if (std::hypot(x, y) < reach)
            points.push_back({{x, y}});
      return points;
    }

    /**
     * Relative motions (normal, t, across; rows) at a distance (x, y) from a square that carries a
     * unit force uniformly (columns): Boussinesq's and Cerruti's point forces, integrated (Johnson
     * 1985, eqs. 3.25 and 3.75-3.76). For two equal bodies, normal and tangential motions are
     * uncoupled.
     */
    std::array<std::array<double, 3>, 3> influence(const double x, const double y) const
    {
      double xx = 0., yy = 0., xy = 0.; // integrals of dx^2 / r^3, dy^2 / r^3 and dx dy / r^3
      for (const double sign_x : {-1., 1.})
        for (const double sign_y : {-1., 1.})
        {
          const double u = x + 0.5 * sign_x * width, v = y + 0.5 * sign_y * width;
          const double r = std::hypot(u, v), sign = sign_x * sign_y;
          xx += sign * v * std::log(u + r);
          yy += sign * u * std::log(v + r);
          xy -= sign * r;
        }
      const double factor = 2. / (2. * M_PI * shear_modulus * area()), nu = poisson_ratio;
      const double all = (1. - nu) * (xx + yy);
      return {{{{factor * all, 0., 0.}},
               {{0., factor * (all + nu * xx), factor * nu * xy}},
               {{0., factor * nu * xy, factor * (all + nu * yy)}}}};
    }

    ComplementarityConstants constants() const
    {
      const auto own = influence(0., 0.);
      return {1. / own[0][0], 1. / own[1][1]};
    }

    /**
     * Pressed with @p load (N) and shifted with @p tangential_load (N), both on the whole sphere,
     * after a step that ended with the forces @p before. The rigid motions are the approach and the
     * shift in this step.
     */
    DenseContact shift(const double load, const double tangential_load,
                       const std::vector<PointVector> &before) const
    {
      const std::vector<std::array<double, 2>> x = points();
      DenseContact problem(x.size(), 2);
      problem.load = {-0.25 * load, 0.25 * tangential_load};
      for (unsigned int i = 0; i < x.size(); ++i)
      {
        problem.free_motion[i][0] = (x[i][0] * x[i][0] + x[i][1] * x[i][1]) / (2. * radius);
        for (unsigned int j = 0; j < x.size(); ++j)
          add_influence(problem, i, j, x[i], x[j]);
        for (unsigned int j = 0; j < x.size(); ++j)
          for (const unsigned int c : {1u, 2u})
            for (const unsigned int d : {1u, 2u})
              problem.free_motion[i][c] -= problem.compliance(3 * i + c, 3 * j + d) * before[j][d];
        problem.rigid_motion(3 * i, 0)     = -1.;
        problem.rigid_motion(3 * i + 1, 1) = 1.;
        problem.balance(0, 3 * i)          = 1.;
        problem.balance(1, 3 * i + 1)      = 1.;
      }
      return problem;
    }

  private:
    /** Of square j and its three images. */
    void add_influence(DenseContact &problem, const unsigned int i, const unsigned int j,
                       const std::array<double, 2> &at, const std::array<double, 2> &from) const
    {
      for (const double sign_x : {-1., 1.})
        for (const double sign_y : {-1., 1.})
        {
          const auto motion = influence(at[0] - sign_x * from[0], at[1] - sign_y * from[1]);
          for (unsigned int c = 0; c < 3; ++c)
            for (unsigned int d = 0; d < 3; ++d)
              problem.compliance(3 * i + c, 3 * j + d) +=
                  (d == 2 ? sign_x * sign_y : 1.) * motion[c][d];
        }
    }
  };
} // namespace ringmotor::tests
