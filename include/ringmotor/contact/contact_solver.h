// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_certificate.h>
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
