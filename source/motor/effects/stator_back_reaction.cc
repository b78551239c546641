// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/parameters/errors.h>

namespace ringmotor::effects
{
  namespace
  {
    /** The frequency of the wave with the rotor on the stator, if the drive follows it. */
    class StatorBackReaction : public Effect
    {
    public:
      StatorBackReaction()
          : Effect({"Stator back-reaction",
                    "Shift of the frequency of the stator's wave by the "
                    "contact forces; the shape of the wave does not change."},
                   EffectStage::contact)
      {
      }

      std::string obstacle(const Parameters &parameters) const override
      {
        return obstacle_if_marched(parameters);
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        model.wave_feels_contact = !parameters.wave.frequency; // else the drive prescribes it
      }

      /** As if all of the preload rested on the crests, see detuning(). */
      std::optional<double> indicator(const Scene &scene) const override
      {
        if (!scene.wave || scene.wave->strain_energy <= 0.)
          return {};
        const Parameters &parameters = scene.parameters;
        return parameters.wave.frequency ? 0.
                                         : parameters.loading.preload * parameters.wave.amplitude /
                                               (4. * scene.wave->strain_energy);
      }
    };
  } // namespace

  EffectPointer stator_back_reaction()
  {
    return std::make_unique<const StatorBackReaction>();
  }
} // namespace ringmotor::effects
