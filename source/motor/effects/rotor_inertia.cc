// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/motor/lip_amplification.h>
#include <ringmotor/motor/ring_modes.h>
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/errors.h>

namespace ringmotor::effects
{
  namespace
  {
    /** Inertia of the rotor, in its modes with two nodal diameters and more. */
    class RotorInertia : public Effect
    {
    public:
      RotorInertia()
          : Effect({"Rotor inertia", "Inertia of the rotor's vibration."}, EffectStage::contact)
      {
      }

      std::string obstacle(const Parameters &parameters) const override
      {
        if (is_marched(parameters))
          // Tilt and shift would be one coupled motion with two inertias.
          return rotor_shape(parameters)->bar_stiffness() == 0.
                     ? " is not available with Rotor/Radial bar stiffness = 0 when the motor is "
                       "marched through time: nothing centres the rotor; allowed: off, or radial "
                       "bars"
                     : "";
        // The motions as a whole are quasi-static, which is adequate only for slow loads and those
        // of high harmonics.
        constexpr unsigned int highest = 6; // harmonic that must not move the rotor as a whole
        const Motor &motor             = parameters.motor;
        for (unsigned int m = 1; m <= highest; ++m)
          if (nodal_diameter_of_harmonic(motor, m) <= 1)
            return " is not available with " +
                   ringmotor::entry("Motor/Number of waves", motor.n_waves) + " and " +
                   ringmotor::entry("Motor/Number of teeth", motor.n_teeth) +
                   " in this version: harmonic " + std::to_string(m) +
                   " of the wave moves the rotor as a whole; allowed: off, or Time/Scheme = "
                   "marching";
        return "";
      }

      void enter(const Parameters &, MotorModel &model) const override
      {
        model.rotor_vibrates       = true;
        model.rotor_moves_as_whole = model.is_marched;
      }

      /** Estimated by the amplification of the lip; where `auto` decides, by operating points if
       * that is near the threshold. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        constexpr double roughly = 3.;
        if (!scene.lip || !scene.wave)
          return measured_in(scene);
        const double rough = scene.lip(choice(scene.parameters) == EffectChoice::off)
                                 .rough_effect(scene.wave->angular_frequency);
        const bool is_near = rough < roughly * scene.threshold &&
                             rough > scene.threshold / roughly &&
                             obstacle(scene.parameters).empty();
        const std::optional<double> measured = is_near ? measured_in(scene) : std::nullopt;
        return measured ? measured : rough;
      }

      double times_as_long() const override { return 5.; }

      void add_cost(const CondensedMotor &motor, EffectRow &row) const override
      {
        add_modes_to(row, motor, ModePart::rotor);
      }
    };
  } // namespace

  EffectPointer rotor_inertia()
  {
    return std::make_unique<const RotorInertia>();
  }
} // namespace ringmotor::effects
