// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/effects/list.h>

#include <cmath>

namespace ringmotor::effects
{
  namespace
  {
    /** Convection of the rotor's deformation by its rotation. */
    class SpinConvection : public Effect
    {
    public:
      SpinConvection()
          : Effect(
                {"Spin convection", "Convection of the rotor's deformation by its own rotation."},
                EffectStage::contact)
      {
      }

      void enter(const Parameters &, MotorModel &) const override {}

      std::string obstacle(const Parameters &) const override
      {
        return " is not available in this version; allowed: off";
      }

      /** For a rotor as fast as the crests: number of waves passed by its rotation relative to
       * those that pass it. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        if (!scene.wave)
          return {};
        const double radius = rotor_shape(scene.parameters)->contact_line().radii.outer;
        const auto top      = scene.wave->top(dealii::Point<3>(radius, 0., 0.));
        return scene.wave->n_waves * std::abs(top[1]) / radius;
      }
    };
  } // namespace

  EffectPointer spin_convection()
  {
    return std::make_unique<const SpinConvection>();
  }
} // namespace ringmotor::effects
