// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/laws/list.h>
#include <ringmotor/parameters/errors.h>

#include <cmath>

namespace ringmotor::laws
{
  namespace
  {
    /** mu_d + (mu_s - mu_d) exp(-v/v_c) with the sliding velocity v = slip / time step. */
    class Velocity : public FrictionLawBase
    {
    public:
      Velocity() : FrictionLawBase({"velocity", "a decay with the sliding velocity"}) {}

      void check(const Friction &friction) const override
      {
        if (!friction.decay_velocity)
          throw UserError(
              "Friction/Law = velocity needs Friction/Decay velocity, which is not set; "
              "give it in m/s");
      }

      FrictionCoefficient coefficient(const Friction &friction, const FrictionMemory &,
                                      const double slip, const double time_step) const override
      {
        const double dynamic      = friction.dynamic_coefficient;
        const double excess       = friction.static_coefficient - dynamic;
        const double decay_length = *friction.decay_velocity * time_step;
        const double decayed      = excess * std::exp(-slip / decay_length);
        return {dynamic + decayed, -decayed / decay_length};
      }

      std::string remedy() const override
      {
        return "; friction that decreases with the velocity decreases more steeply with the slip "
               "of "
               "a shorter step, and contact nodes may then stick or slip at the same load: try a "
               "smaller Time/Snapshots, Time/Scheme = marching, or a larger Friction/Decay "
               "velocity";
      }
    };
  } // namespace

  LawPointer velocity()
  {
    return std::make_unique<const Velocity>();
  }
} // namespace ringmotor::laws
