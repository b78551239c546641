// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/friction_law.h>
#include <ringmotor/motor/effects/list.h>

namespace ringmotor::effects
{
  namespace
  {
    /** Friction that is larger at rest, by the given law. */
    class StaticFrictionExcess : public Effect
    {
    public:
      StaticFrictionExcess()
          : Effect({"Static friction excess",
                    "A static coefficient of friction above the dynamic one."},
                   EffectStage::contact)
      {
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        model.friction.static_coefficient = parameters.friction.static_coefficient;
      }

      /** Zero without an excess; otherwise determined in the run, see
       * CurveSearch::static_friction_effect(). */
      std::optional<double> indicator(const Scene &scene) const override
      {
        return has_static_excess(scene.parameters.friction) ? std::nullopt
                                                            : std::optional<double>(0.);
      }
    };
  } // namespace

  EffectPointer static_friction_excess()
  {
    return std::make_unique<const StaticFrictionExcess>();
  }
} // namespace ringmotor::effects
