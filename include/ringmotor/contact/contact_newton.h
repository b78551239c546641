// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_certificate.h>

#include <vector>

namespace ringmotor
{
  /** Turn the complementarity conditions into equations; N/m. */
  struct ComplementarityConstants
  {
    double normal;     ///< about 1 / normal compliance of a point
    double tangential; ///< about 1 / largest eigenvalue of the tangential compliance of a tooth
  };

  /** What Newton's method left. */
  struct ContactIterate
  {
    ContactState state;
    std::vector<PointVector> motion; ///< gap and slip (m) by point
    ContactCertificate certificate;
    unsigned int n_iterations = 0; ///< linear problems solved
    bool failed = false; ///< a linear problem was singular or too large, or the result is no number

    bool certified() const { return !failed && certificate.holds(); }
  };

  /**
   * The semi-smooth Newton method (primal-dual active set) for contact with friction:
   * p = max(0, p - c_n gap), and for a touching point either slip = 0 or
   * F_t = bound tau/|tau|, tau = F_t - c_t slip. (Alart and Curnier 1991; Hueeber, Stadler and
   * Wohlmuth 2008.) Where a linear problem is singular, because too few points touch or stick to
   * hold the rigid motions, it starts once more from the state in which all points stick, if there
   * are not too many of them.
   *
   * @return the last iterate, whether it has converged or not
   */
  ContactIterate newton(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                        const ComplementarityConstants &constants, const ContactState &start,
                        const unsigned int most_iterations);

  /**
   * The same for smoothed friction, F_t = - bound slip / sqrt(|slip|^2 + smoothing^2), which holds
   * rigid motions although nothing sticks. Its linear problems are those of a primal-dual method
   * (Chan, Golub and Mulet 1999): a force outside the bound does not enter the derivatives. Ends
   * when forces change by less than 1e-3; its certificate is that of the smooth law's state under
   * Coulomb's law and does not tell.
   *
   * @param smoothing m, not zero
   */
  ContactIterate smoothed_newton(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                                 const ComplementarityConstants &constants,
                                 const ContactState &start, const double smoothing,
                                 const unsigned int most_iterations);

  /** The state in which all points touch and stick, whether they are pressed or pulled. */
  ContactIterate stick_everywhere(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                                  const ComplementarityConstants &constants);

  /** Whether that state can be afforded: its matrix has three rows for each point and is dense. */
  bool can_stick_everywhere(const ContactProblem &problem);
} // namespace ringmotor
