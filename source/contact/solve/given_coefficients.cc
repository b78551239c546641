// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/solve/given_coefficients.h>

namespace ringmotor
{
  GivenCoefficients::GivenCoefficients(const PointFriction &law, const unsigned int n_points,
                                       const std::vector<PointVector> &motion)
      : law(law)
  {
    for (unsigned int i = 0; i < n_points; ++i)
      coefficients.push_back(law(i, motion.empty() ? 0. : tangential_norm(motion[i])).value);
  }

  double GivenCoefficients::update(const ContactState &state,
                                   const std::vector<PointVector> &motion)
  {
    double change = 0.;
    for (unsigned int i = 0; i < coefficients.size(); ++i)
    {
      const double next = law(i, tangential_norm(motion[i])).value;
      if (state.force[i][0] > 0.)
        change = std::max(change, std::abs(next - coefficients[i]) / next);
      coefficients[i] = next;
    }
    return change;
  }
} // namespace ringmotor
