// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/motor/ring_modes.h>

namespace ringmotor::effects
{
  namespace
  {
    /** Motions of the stator below its teeth under contact forces, beside the wave, with inertia.
     */
    class StatorCompliance : public Effect
    {
    public:
      StatorCompliance()
          : Effect({"Stator compliance",
                    "Elasticity and inertia of the stator below its teeth under contact forces: "
                    "all of its modes but the one that drives the motor. It multiplies the time of "
                    "each operating point: off unless asked for, with on or auto.",
                    EffectChoice::off},
                   EffectStage::contact)
      {
      }

      std::string obstacle(const Parameters &parameters) const override
      {
        return obstacle_if_marched(parameters);
      }

      void enter(const Parameters &, MotorModel &model) const override
      {
        model.stator_gives_way = true;
      }

      std::optional<double> indicator(const Scene &scene) const override
      {
        return measured_in(scene);
      }

      double times_as_long() const override { return 2.; }

      /** Many of its modes are so high that with one snapshot, half of the change is missing. */
      unsigned int n_snapshots_to_measure() const override { return 2; }

      void add_cost(const CondensedMotor &motor, EffectRow &row) const override
      {
        add_modes_to(row, motor, ModePart::stator);
      }
    };
  } // namespace

  EffectPointer stator_compliance()
  {
    return std::make_unique<const StatorCompliance>();
  }
} // namespace ringmotor::effects
