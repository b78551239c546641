// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_problem.h>

#include <functional>
#include <vector>

namespace ringmotor
{
  /** The largest friction force of a contact node and its derivatives. */
  struct FrictionBound
  {
    double value       = 0.; ///< N
    double by_pressure = 0.; ///< by the pressure force
    double by_slip     = 0.; ///< N/m, by the length of the slip
  };

  /** The friction bound of a node under a pressure force (N) for a slip (m, not negative). */
  using FrictionBoundOf =
      std::function<FrictionBound(unsigned int point, double pressure_force, double slip)>;

  /**
   * By how much a state violates the laws of contact and friction, as pure numbers that are zero
   * but for rounding in a solution.
   *
   * Pressure forces are scaled by the largest one, friction by the largest bound. Gaps and slips
   * are scaled by the largest change of them by the forces at touching nodes, slips also by the
   * largest slip there. To keep rounding from counting where these are tiny (rigid bodies, sticking
   * nodes), the scales are at least 1e-8 of the gaps and slips without forces and rigid motions,
   * and that of slips at least 1e-5 of that of gaps. Balances are scaled by the sum of the pressure
   * forces or by the load to be balanced.
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

  /** The distance (N) of the friction in @p force from tau = F_t - stiffness slip, shortened to
   * @p bound (N): zero where the law of friction is fulfilled, for any stiffness (N/m). */
  double friction_defect(const PointVector &force, const PointVector &motion,
                         const double stiffness, const double bound);

  /** @param motion the relative motion in this state */
  ContactCertificate certify(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                             const ContactState &state, const std::vector<PointVector> &motion);
} // namespace ringmotor
