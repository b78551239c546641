// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/condensed_bodies.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/effects/list.h>

namespace ringmotor::effects
{
  namespace
  {
    /** Inertia of the teeth in the motion that the base drives: their tops move as in the mode. */
    class ToothInertia : public Effect
    {
    public:
      ToothInertia()
          : Effect({"Tooth inertia", "Inertia of the teeth in the motion that the base drives."},
                   EffectStage::contact)
      {
      }

      void enter(const Parameters &, MotorModel &model) const override
      {
        model.teeth_move_with_inertia = true;
      }

      bool is_free() const override { return true; }

      /** The change of the circumferential motion of the top, driven by the foot, which drives the
       * rotor: (omega / omega_1)^2 of the tooth. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        return scene.wave
                   ? std::optional<double>(tooth_inertia_indicator(scene.parameters, *scene.wave))
                   : std::nullopt;
      }
    };
  } // namespace

  EffectPointer tooth_inertia()
  {
    return std::make_unique<const ToothInertia>();
  }
} // namespace ringmotor::effects
