// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/parameters/errors.h>

namespace ringmotor::effects
{
  namespace
  {
    /** Internal damping of the rotor's vibration. */
    class Damping : public Effect
    {
    public:
      Damping() : Effect("Damping", &Effects::damping, EffectStage::contact) {}

      void check(const Parameters &parameters) const override
      {
        if (choice(parameters) == EffectChoice::on &&
            parameters.effects.rotor_inertia == EffectChoice::off)
          throw UserError(given(parameters) +
                          " is available with Effects/Rotor inertia = on | auto "
                          "only; allowed: off | auto");
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        model.rotor_loss_factor = parameters.materials.rotor_metal.loss_factor;
      }

      /** None without a rotor that vibrates; else it takes part. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        return scene.parameters.effects.rotor_inertia == EffectChoice::off
                   ? std::optional<double>(0.)
                   : std::nullopt;
      }
    };
  } // namespace

  EffectPointer damping()
  {
    return std::make_unique<const Damping>();
  }
} // namespace ringmotor::effects
