// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_problem.h>

#include <functional>
#include <vector>

namespace ringmotor
{
  /** The largest friction force of a point and how it changes. */
  struct FrictionBound
  {
    double value       = 0.; ///< N
    double by_pressure = 0.; ///< by the pressure force
    double by_slip     = 0.; ///< N/m, by the length of the slip
  };

  /** The friction bound of a point under a pressure force (N) for a slip (m, not negative). */
  using FrictionBoundOf =
      std::function<FrictionBound(unsigned int point, double pressure_force, double slip)>;

  /**
   * How far a state is from the laws of contact and friction, each a pure number that rounding
   * alone should make different from zero.
   *
   * Pressure forces are compared with the largest, friction with the largest bound. Gaps and slips
   * are compared with how much the forces change them at points that touch, slips also with the
   * largest slip there; so that rounding does not count where little is left of these (rigid
   * bodies, points that stick), not with less than 1e-8 of what there is without forces and rigid
   * motions, slips not with less than 1e-5 of what gaps are compared with. Balances are compared
   * with the sum of the pressure forces or with what is to be balanced.
   */
  struct ContactCertificate
  {
    double tension         = 0.; ///< largest p < 0
    double penetration     = 0.; ///< largest gap < 0
    double complementarity = 0.; ///< largest of min(|p|, |gap|)
    double friction_excess = 0.; ///< largest |F_t| - bound > 0
    double friction_defect = 0.; ///< largest change if F_t - slip is projected to the bound
    double balance         = 0.; ///< largest balance

    /** The largest of them, NaN if one is. */
    double worst() const;
    static constexpr double limit = 1e-7;
    bool holds() const { return worst() <= limit; }
  };

  /** By how much (N) the friction in @p force misses tau = F_t - stiffness slip, shortened to
   * @p bound (N): zero where the law of friction is fulfilled, whatever the stiffness (N/m). */
  double friction_defect(const PointVector &force, const PointVector &motion,
                         const double stiffness, const double bound);

  /** @param motion the relative motion in this state */
  ContactCertificate certify(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                             const ContactState &state, const std::vector<PointVector> &motion);
} // namespace ringmotor
