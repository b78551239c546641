// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>

namespace ringmotor::effects
{
  namespace
  {
    /** A ring that is warped at rest. */
    class InitialDeformation : public Effect
    {
    public:
      InitialDeformation()
          : Effect("Initial deformation", &Effects::initial_deformation, EffectStage::contact)
      {
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        const ringmotor::InitialDeformation &deformation = parameters.initial_deformation;
        if (deformation.amplitude > 0.)
          model.warp = {deformation.amplitude, deformation.n_waves};
      }

      void forget(Parameters &parameters) const override { parameters.initial_deformation = {}; }

      /** The warp relative to the height of the wave. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        return scene.parameters.initial_deformation.amplitude / scene.parameters.wave.amplitude;
      }
    };
  } // namespace

  EffectPointer initial_deformation()
  {
    return std::make_unique<const InitialDeformation>();
  }
} // namespace ringmotor::effects
