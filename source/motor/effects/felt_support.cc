// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/prm_file.h>

namespace ringmotor::effects
{
  namespace
  {
    /** The felt that carries the stator, as springs under its lower side. */
    class FeltSupport : public Effect
    {
    public:
      FeltSupport()
          : Effect({"Felt support",
                    "Stiffness of the felt, given in the section Support, in the modes of the "
                    "stator; the program losses includes its loss in any case."},
                   EffectStage::stator)
      {
      }

      void check(const Parameters &parameters) const override
      {
        const Support &felt          = parameters.support;
        const StatorGeometry &stator = parameters.stator;
        if (!felt.has_felt() && choice(parameters) == EffectChoice::on)
          throw UserError(given(parameters) +
                          " needs Support/Felt thickness, Felt modulus and Felt "
                          "loss factor, found none; allowed: off | auto, or a "
                          "felt");
        if (!felt.has_felt())
          return;
        if (!stator.has_dimensions()) // the faces named felt
          return;
        if (felt.felt_inner_radius.value_or(0.) > stator.base_inner_radius ||
            felt.felt_outer_radius.value_or(stator.base_outer_radius) < stator.base_outer_radius)
          throw UserError(
              given(parameters) +
              " needs a felt under the whole base; allowed: Support/Felt inner radius = "
              "base and Felt outer radius = base, or off");
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        model.felt_stiffness = parameters.support.stiffness();
      }

      void forget(Parameters &parameters) const override { parameters.support = {}; }

      /** Zero without a felt. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        return scene.parameters.support.has_felt() ? measured_in(scene) : 0.;
      }
    };
  } // namespace

  EffectPointer felt_support()
  {
    return std::make_unique<const FeltSupport>();
  }
} // namespace ringmotor::effects
