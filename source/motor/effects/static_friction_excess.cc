// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>

#include <cmath>

namespace ringmotor::effects
{
  namespace
  {
    /** Friction that is larger at rest, by the law that was given. */
    class StaticFrictionExcess : public Effect
    {
    public:
      StaticFrictionExcess()
          : Effect("Static friction excess", &Effects::static_friction_excess, EffectStage::contact)
      {
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        model.friction.law = parameters.friction.law;
      }

      /** The excess of the coefficient, which at most all points feel. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        const Friction &friction = scene.parameters.friction;
        return friction.law == FrictionLaw::coulomb
                   ? 0.
                   : std::abs(friction.static_coefficient / friction.dynamic_coefficient - 1.);
      }
    };
  } // namespace

  EffectPointer static_friction_excess()
  {
    return std::make_unique<const StaticFrictionExcess>();
  }
} // namespace ringmotor::effects
