// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/solve/contact_certificate.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ringmotor
{
  namespace
  {
    /** The larger one; a NaN is larger than any number. */
    double larger(const double a, const double b)
    {
      return a <= b || std::isnan(b) ? b : a;
    }

    /** The smaller one; a NaN is smaller than any number. */
    double smaller(const double a, const double b)
    {
      return a <= b || std::isnan(a) ? a : b;
    }

    /** Scales of the violations; none is zero. */
    struct Scales
    {
      double force, friction, gap, slip, balance;
    };

    Scales scales_of(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                     const ContactState &state, const std::vector<PointVector> &motion)
    {
      const ContactState free{std::vector<PointVector>(state.force.size()), state.rigid};
      const ContactState nothing{free.force, std::vector<double>(state.rigid.size())};
      const std::vector<PointVector> free_motion = problem.relative_motion(free),
                                     at_first    = problem.relative_motion(nothing);
      Scales scales{0., 0., 0., 0., 0.};
      for (unsigned int i = 0; i < state.force.size(); ++i)
      {
        constexpr double rounding = 1e-8;
        scales.gap                = larger(scales.gap, rounding * std::abs(at_first[i][0]));
        scales.slip               = larger(scales.slip, rounding * tangential_norm(at_first[i]));
        if (!(state.force[i][0] > 0.))
          continue;
        const PointVector by_forces = motion[i] - free_motion[i];
        scales.gap                  = larger(scales.gap, std::abs(by_forces[0]));
        scales.slip =
            larger(scales.slip, larger(tangential_norm(by_forces), tangential_norm(motion[i])));
        scales.force       = larger(scales.force, state.force[i][0]);
        const double bound = bound_of(i, state.force[i][0], tangential_norm(motion[i])).value;
        scales.friction    = larger(scales.friction, bound);
        scales.balance += state.force[i][0];
      }
      // The tangential motions of sticking bodies cancel.
      scales.slip = larger(scales.slip, 1e-5 * scales.gap);
      for (const double load : problem.balances(nothing))
        scales.balance = larger(scales.balance, std::abs(load));
      if (scales.friction == 0.)
        scales.friction = scales.force;
      for (double *scale :
           {&scales.force, &scales.friction, &scales.gap, &scales.slip, &scales.balance})
      {
        if (*scale == 0.)
          *scale = 1.;
        if (std::isinf(*scale)) // any violation would seem small
          *scale = std::numeric_limits<double>::quiet_NaN();
      }
      return scales;
    }
  } // namespace

  double ContactCertificate::worst() const
  {
    double worst = 0.;
    for (const double entry :
         {tension, penetration, complementarity, friction_excess, friction_defect, balance})
      worst = larger(worst, entry);
    return worst;
  }

  double friction_defect(const PointVector &force, const PointVector &motion,
                         const double stiffness, const double bound)
  {
    const PointVector tau = force - stiffness * motion;
    const double size     = tangential_norm(tau);
    const double part     = size > bound ? bound / size : 1.;
    return tangential_norm(force - part * tau);
  }

  ContactCertificate certify(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                             const ContactState &state, const std::vector<PointVector> &motion)
  {
    const Scales scales    = scales_of(problem, bound_of, state, motion);
    const double stiffness = scales.friction / scales.slip;
    ContactCertificate found;
    for (unsigned int i = 0; i < state.force.size(); ++i)
    {
      const double p = state.force[i][0] / scales.force, gap = motion[i][0] / scales.gap;
      found.tension         = larger(found.tension, -p);
      found.penetration     = larger(found.penetration, -gap);
      found.complementarity = larger(found.complementarity, smaller(std::abs(p), std::abs(gap)));
      const double friction = tangential_norm(state.force[i]), slip = tangential_norm(motion[i]);
      const double bound    = p > 0. ? bound_of(i, state.force[i][0], slip).value : 0.;
      found.friction_excess = larger(found.friction_excess, (friction - bound) / scales.friction);
      if (p <= 0.)
        continue;
      found.friction_defect =
          larger(found.friction_defect,
                 friction_defect(state.force[i], motion[i], stiffness, bound) / scales.friction);
    }
    for (const double balance : problem.balances(state))
      found.balance = larger(found.balance, std::abs(balance) / scales.balance);
    return found;
  }
} // namespace ringmotor
