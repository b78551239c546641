// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/parameters/errors.h>

namespace ringmotor::effects
{
  namespace
  {
    /** A lining between teeth and rotor, as springs by area. */
    class FrictionLining : public Effect
    {
    public:
      FrictionLining()
          : Effect({"Friction lining",
                    "Finite stiffness of a friction lining, given in the section Friction."},
                   EffectStage::contact)
      {
      }

      void check(const Parameters &parameters) const override
      {
        if (choice(parameters) == EffectChoice::on && !is_given(parameters.friction))
          throw UserError(given(parameters) + " needs Friction/Lining normal stiffness and "
                                              "Friction/Lining tangential stiffness; give both in "
                                              "N/m^3");
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        if (!is_given(parameters.friction))
          return;
        model.lining_normal_compliance     = 1. / *parameters.friction.lining_normal_stiffness;
        model.lining_tangential_compliance = 1. / *parameters.friction.lining_tangential_stiffness;
      }

      void forget(Parameters &parameters) const override
      {
        parameters.friction.lining_normal_stiffness     = {};
        parameters.friction.lining_tangential_stiffness = {};
      }

      /** Zero without a given stiffness; else the compression of the lining under the preload on a
       * tenth of the lip, relative to the height of the wave. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        const Parameters &parameters = scene.parameters;
        if (!is_given(parameters.friction))
          return 0.;
        constexpr double share = 0.1;
        const double area      = share * rotor_shape(parameters)->contact_line().radii.area();
        return parameters.loading.preload / area / *parameters.friction.lining_normal_stiffness /
               parameters.wave.amplitude;
      }

    private:
      static bool is_given(const Friction &friction)
      {
        return friction.lining_normal_stiffness && friction.lining_tangential_stiffness;
      }
    };
  } // namespace

  EffectPointer friction_lining()
  {
    return std::make_unique<const FrictionLining>();
  }
} // namespace ringmotor::effects
