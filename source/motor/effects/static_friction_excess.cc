// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>

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

      /** None where there is no excess; else only a run can tell, see
       * CurveSearch::static_friction_effect(). */
      std::optional<double> indicator(const Scene &scene) const override
      {
        const Friction &friction = scene.parameters.friction;
        const bool is_one        = friction.law == FrictionLaw::coulomb ||
                            friction.static_coefficient == friction.dynamic_coefficient;
        return is_one ? std::optional<double>(0.) : std::nullopt;
      }
    };
  } // namespace

  EffectPointer static_friction_excess()
  {
    return std::make_unique<const StaticFrictionExcess>();
  }
} // namespace ringmotor::effects
