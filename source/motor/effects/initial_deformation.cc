// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/errors.h>

namespace ringmotor::effects
{
  namespace
  {
    /** A ring that is warped at rest. */
    class InitialDeformation : public Effect
    {
    public:
      InitialDeformation()
          : Effect({"Initial deformation",
                    "Warp of the stator at rest, given in the section Initial deformation."},
                   EffectStage::contact)
      {
      }

      void check(const Parameters &parameters) const override
      {
        const double amplitude = parameters.initial_deformation.amplitude;
        if (amplitude > 0. && parameters.time.scheme == TimeScheme::steady)
          throw UserError("Time/Scheme = steady is incompatible with " +
                          ringmotor::entry("Initial deformation/Amplitude", amplitude) +
                          ": a warped ring has no steady pattern; allowed: auto | marching, or "
                          "Effects/Initial deformation = off");
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        const ringmotor::InitialDeformation &deformation = parameters.initial_deformation;
        if (deformation.amplitude == 0.)
          return;
        model.warp = {deformation.amplitude, deformation.n_waves};
        if (parameters.time.scheme == TimeScheme::automatic)
          model.is_marched = true;
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
