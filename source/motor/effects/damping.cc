// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/motor/rotor_loss.h>
#include <ringmotor/parameters/errors.h>

namespace ringmotor::effects
{
  namespace
  {
    /** Internal damping of the rotor: of its vibration or, without inertia, hysteretic. */
    class Damping : public Effect
    {
    public:
      Damping()
          : Effect({"Damping", "Internal damping of the rotor's motion by the loss factors of its "
                               "parts; the program losses includes the loss in any case."},
                   EffectStage::contact)
      {
      }

      std::string obstacle(const Parameters &parameters) const override
      {
        const MotorModel model = motor_model(parameters);
        if (!model.is_marched || model.rotor_vibrates)
          return "";
        return " is not available with Effects/Rotor inertia = off when the motor is marched "
               "through time: hysteresis needs harmonics of a steady state; allowed: off, or "
               "Effects/Rotor inertia = on";
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        // Without inertia the choice of `auto` is still open.
        if (choice(parameters) == EffectChoice::on || model.rotor_vibrates)
          model.rotor_loss_factor = largest_rotor_loss_factor(parameters);
      }

      /** Always on if the rotor vibrates. Hysteresis delays the rotor's motion by the fraction eta;
       * single steps in time neglect it. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        return motor_model(scene.parameters).rotor_vibrates
                   ? std::nullopt
                   : std::optional<double>(rotor_loss_factor(scene.parameters));
      }
    };
  } // namespace

  EffectPointer damping()
  {
    return std::make_unique<const Damping>();
  }
} // namespace ringmotor::effects
