// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/friction.h>

#include <cmath>

namespace ringmotor
{
  FrictionCoefficient friction_coefficient(const Friction &friction, const FrictionMemory &memory,
                                           const double slip, const double time_step)
  {
    const double dynamic = friction.dynamic_coefficient;
    const double excess  = friction.static_coefficient - dynamic;
    switch (friction.law)
    {
    case FrictionLaw::coulomb:
      return {dynamic, 0.};
    case FrictionLaw::static_dynamic:
      return {memory.stuck ? dynamic + excess : dynamic, 0.};
    case FrictionLaw::velocity:
    {
      const double decay_length = *friction.decay_velocity * time_step;
      const double decayed      = excess * std::exp(-slip / decay_length);
      return {dynamic + decayed, -decayed / decay_length};
    }
    case FrictionLaw::slip_weakening:
    {
      const double left = 1. - (memory.slipped + slip) / *friction.weakening_length;
      if (left <= 0.)
        return {dynamic, 0.};
      return {dynamic + left * excess, -excess / *friction.weakening_length};
    }
    }
    return {};
  }
} // namespace ringmotor
