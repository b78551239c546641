// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/condensed_bodies.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/effects/list.h>

namespace ringmotor::effects
{
  namespace
  {
    /** Inertia of the teeth under contact forces, in their modes. */
    class ToothVibration : public Effect
    {
    public:
      ToothVibration()
          : Effect({"Tooth vibration",
                    "Inertia of the teeth under contact forces, in addition to Tooth inertia."},
                   EffectStage::contact)
      {
      }

      std::string obstacle(const Parameters &parameters) const override
      {
        return !motor_model(parameters).teeth_move_with_inertia
                   ? " is not available with Effects/Tooth inertia = off; allowed: off, or Tooth "
                     "inertia = on"
                   : "";
      }

      void enter(const Parameters &, MotorModel &model) const override
      {
        model.teeth_vibrate = model.teeth_move_with_inertia;
      }

      /** Friction excites the lowest mode of a tooth, at whose frequency a harmonic of the wave may
       * be: the change has been found to be a seventh to one and a half times that by Tooth
       * inertia. Where `auto` decides, by operating points unless it is small in any case. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        constexpr double margin = 3.;
        if (!motor_model(scene.parameters).teeth_move_with_inertia)
          return 0.;
        if (!scene.wave)
          return std::nullopt;
        const double at_most = margin * tooth_inertia_indicator(scene.parameters, *scene.wave);
        const std::optional<double> measured =
            at_most > scene.threshold ? measured_in(scene) : std::nullopt;
        return measured ? measured : at_most;
      }

      void add_cost(const CondensedMotor &motor, EffectRow &row) const override
      {
        add_modes_to(row, motor, ModePart::tooth);
      }
    };
  } // namespace

  EffectPointer tooth_vibration()
  {
    return std::make_unique<const ToothVibration>();
  }
} // namespace ringmotor::effects
