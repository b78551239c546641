// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "support/dense_contact.h"

#include <cmath>
#include <vector>

namespace ringmotor::tests
{
  /** Two elastic half-planes in plane strain, of unit thickness. */
  struct HalfPlanes
  {
    double shear_modulus_upper, poisson_upper, shear_modulus_lower, poisson_lower;

    /** 1 / E* of Hertz's theory. */
    double compliance() const
    {
      return (1. - poisson_upper) / (2. * shear_modulus_upper) +
             (1. - poisson_lower) / (2. * shear_modulus_lower);
    }
    /** Excess shortening of the upper surface over the lower one per unit of pressure; it is
     * 2 beta / E* with Dundurs' beta. */
    double mismatch() const
    {
      return (1. - 2. * poisson_upper) / (2. * shear_modulus_upper) -
             (1. - 2. * poisson_lower) / (2. * shear_modulus_lower);
    }

    /**
     * Relative motion at a distance @p x along t from the middle of a strip of width @p h that
     * carries a unit force uniformly; same direction of force and motion. Flamant's logarithm
     * (Johnson 1985, eqs. 2.25), set to zero at a distance @p far.
     */
    double direct(const double x, const double h, const double far) const
    {
      const auto integral = [&](const double s)
      { return s == 0. ? 0. : s * (std::log(std::abs(s) / far) - 1.); };
      return -2. / M_PI * compliance() * (integral(x + 0.5 * h) - integral(x - 0.5 * h)) / h;
    }

    /** The same for the gap due to a tangential force, and the negative of the tangential motion
     * due to a normal force. */
    double cross(const double x, const double h) const
    {
      return mismatch() * std::max(-0.5, std::min(0.5, x / h));
    }
  };

  /** Contact of two cylinders along a line, in equal strips. */
  struct LineContact
  {
    HalfPlanes bodies;
    double radius;         ///< m, 1 / (1/R1 + 1/R2)
    double first;          ///< m, middle of the first strip along t
    double width;          ///< m, of a strip
    unsigned int n_strips; ///< of the region that may touch

    double x(const unsigned int i) const { return first + i * width; }
    double far() const { return 10. * n_strips * width; }

    /** Constants that suit the compliance of one strip. */
    ComplementarityConstants constants() const
    {
      const double stiffness = 1. / bodies.direct(0., width, far());
      return {stiffness, stiffness};
    }

    /**
     * The bodies are pressed together by @p load (N); the first rigid motion is their approach. In
     * a step the upper body shifts by the second rigid motion, under a tangential force
     * @p tangential_load (N); the previous forces are zero.
     */
    DenseContact shift(const double load, const double tangential_load) const
    {
      DenseContact problem = pressed(load, 2);
      add_tangential_rows(problem, 0., 1.);
      free_tangentially(problem, tangential_load, 1.);
      return problem;
    }

    /**
     * Steady rolling: material flows through the contact along t, one strip per step. The second
     * rigid motion is the creep, the rigid slip over the distance rolled; @p tangential_load (N)
     * acts on the upper body.
     */
    DenseContact rolling(const double load, const double tangential_load) const
    {
      DenseContact problem = pressed(load, 2);
      add_rolling_rows(problem);
      free_tangentially(problem, tangential_load, width);
      return problem;
    }

    /** The same with a given creep. */
    DenseContact rolling_with_creep(const double load, const double creep) const
    {
      DenseContact problem = pressed(load, 1);
      add_rolling_rows(problem);
      for (PointVector &motion : problem.free_motion)
        motion[1] = creep * width;
      return problem;
    }

  private:
    DenseContact pressed(const double load, const unsigned int n_rigid) const
    {
      DenseContact problem(n_strips, n_rigid);
      problem.load[0] = -load;
      for (unsigned int i = 0; i < n_strips; ++i)
      {
        problem.free_motion[i][0] = x(i) * x(i) / (2. * radius);
        for (unsigned int j = 0; j < n_strips; ++j)
        {
          problem.compliance(3 * i, 3 * j)     = bodies.direct(x(i) - x(j), width, far());
          problem.compliance(3 * i, 3 * j + 1) = bodies.cross(x(i) - x(j), width);
        }
        // The third direction is not used.
        problem.compliance(3 * i + 2, 3 * i + 2) = bodies.direct(0., width, far());
        problem.rigid_motion(3 * i, 0)           = -1.;
        problem.balance(0, 3 * i)                = 1.;
      }
      return problem;
    }

    /** Adds a multiple of the tangential displacements at a distance @p away along t. */
    void add_tangential_rows(DenseContact &problem, const double away, const double factor) const
    {
      for (unsigned int i = 0; i < n_strips; ++i)
        for (unsigned int j = 0; j < n_strips; ++j)
        {
          const double distance = x(i) + away - x(j);
          problem.compliance(3 * i + 1, 3 * j) -= factor * bodies.cross(distance, width);
          problem.compliance(3 * i + 1, 3 * j + 1) +=
              factor * bodies.direct(distance, width, far());
        }
    }

    /** Displacements minus those of the strip upstream. */
    void add_rolling_rows(DenseContact &problem) const
    {
      add_tangential_rows(problem, 0., 1.);
      add_tangential_rows(problem, -width, -1.);
    }

    void free_tangentially(DenseContact &problem, const double tangential_load,
                           const double motion) const
    {
      problem.load[1] = tangential_load;
      for (unsigned int i = 0; i < n_strips; ++i)
      {
        problem.rigid_motion(3 * i + 1, 1) = motion;
        problem.balance(1, 3 * i + 1)      = 1.;
      }
    }
  };
} // namespace ringmotor::tests
