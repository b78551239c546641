// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>

namespace ringmotor::effects
{
  namespace
  {
    /** Compliance of the rotor under friction; under pressure it is always compliant. */
    class RotorTangentialCompliance : public Effect
    {
    public:
      RotorTangentialCompliance()
          : Effect(
                {"Rotor tangential compliance", "Elasticity of the rotor under friction forces."},
                EffectStage::contact)
      {
      }

      void enter(const Parameters &, MotorModel &model) const override
      {
        model.rotor_gives_way_along = true;
      }
    };
  } // namespace

  EffectPointer rotor_tangential_compliance()
  {
    return std::make_unique<const RotorTangentialCompliance>();
  }
} // namespace ringmotor::effects
