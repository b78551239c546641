// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>

namespace ringmotor::effects
{
  namespace
  {
    /** Compliance of the teeth under contact forces. */
    class ToothShear : public Effect
    {
    public:
      ToothShear()
          : Effect({"Tooth shear", "Elasticity of the teeth under contact forces; \"auto\", here "
                                   "and below, switches an effect on if it may be significant."},
                   EffectStage::contact)
      {
      }

      void enter(const Parameters &, MotorModel &model) const override
      {
        model.teeth_give_way = true;
      }
    };
  } // namespace

  EffectPointer tooth_shear()
  {
    return std::make_unique<const ToothShear>();
  }
} // namespace ringmotor::effects
