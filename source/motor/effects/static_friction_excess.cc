// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/friction_law.h>
#include <ringmotor/motor/effects/list.h>

namespace ringmotor::effects
{
  namespace
  {
    /** Friction that is larger at rest, by the given law. */
    class StaticFrictionExcess : public Effect
    {
    public:
      StaticFrictionExcess()
          : Effect({"Static friction excess",
                    "A static coefficient of friction above the dynamic one."},
                   EffectStage::contact)
      {
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        model.friction.static_coefficient = parameters.friction.static_coefficient;
      }

      /** By operating points; zero without an excess. A jump from static to dynamic friction hardly
       * matters, least on fine meshes. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        return has_static_excess(scene.parameters.friction) ? measured_in(scene)
                                                            : std::optional<double>(0.);
      }

      bool is_chosen_last() const override { return true; }

      /** What sticks and what slips is found by repeated solutions. */
      double times_as_long() const override { return 2.; }
    };
  } // namespace

  EffectPointer static_friction_excess()
  {
    return std::make_unique<const StaticFrictionExcess>();
  }
} // namespace ringmotor::effects
