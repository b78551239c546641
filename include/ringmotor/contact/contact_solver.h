// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_problem.h>
#include <ringmotor/contact/friction.h>

#include <functional>
#include <string>
#include <vector>

namespace ringmotor
{
  enum class PointStatus : unsigned char
  {
    open,
    stick,
    slip
  };

  /**
   * How far a state is from the laws of contact and friction, each a pure number that rounding
   * alone should make different from zero. Forces are compared with the largest pressure force,
   * gaps with the elastic displacement under it, and slips with the largest slip.
   */
  struct ContactCertificate
  {
    double tension         = 0.; ///< largest p < 0
    double penetration     = 0.; ///< largest gap < 0
    double complementarity = 0.; ///< largest |p gap|
    double friction_excess = 0.; ///< largest |F_t| - mu p > 0
    double friction_defect = 0.; ///< largest |F_t slip + mu p |slip||: friction opposes slip
    double balance         = 0.; ///< largest balance, against the sum of the pressure forces

    double worst() const;
    static constexpr double limit = 1e-7;
    bool holds() const { return worst() <= limit; }
  };

  /** The solution of a contact problem. */
  struct ContactSolution
  {
    ContactState state;
    std::vector<PointVector> motion; ///< gap and slip (m) by point
    std::vector<PointStatus> status;
    ContactCertificate certificate;
    unsigned int n_iterations = 0; ///< linear problems solved
    std::string how;               ///< what was tried, in words, if Newton's method alone failed
  };

  /** Turn the complementarity conditions into equations; N/m. */
  struct ComplementarityConstants
  {
    double normal;     ///< about 1 / normal compliance of a point
    double tangential; ///< about 1 / largest eigenvalue of the tangential compliance of a tooth
  };

  /** The coefficient of friction of a point for a slip (m, not negative). */
  using PointFriction = std::function<FrictionCoefficient(unsigned int point, double slip)>;

  /**
   * Solves a contact problem with friction by the semi-smooth Newton method (primal-dual active
   * set): p = max(0, p - c_n gap), and for a touching point either slip = 0 or
   * F_t = mu p tau/|tau|, tau = F_t - c_t slip. (Alart and Curnier 1991; Hueeber, Stadler
   * and Wohlmuth 2008.)
   *
   * If Newton's iterates do not settle, smaller constants are tried, and then a fixed point on the
   * friction bounds with inner problems of given bound (Tresca), which are convex.
   *
   * @throws ComputationError if nothing converged to a state that certifies.
   */
  ContactSolution solve_contact(const ContactProblem &problem, const PointFriction &friction,
                                const ComplementarityConstants &constants,
                                const ContactState &start);
} // namespace ringmotor
