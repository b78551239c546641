// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/friction_law.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/parameters/accuracy_budget.h>
#include <ringmotor/parameters/errors.h>

#include <chrono>
#include <cmath>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    std::string per_cent(const double share)
    {
      std::ostringstream text;
      text.precision(2);
      text << 100. * share << " %";
      return text.str();
    }
    /** Whether `auto` includes an effect. One that this motor cannot have is left out as long as
     * the error bars may have it. @throws ComputationError if they may not */
    bool auto_includes(const Effect &effect, const double indicator, const Parameters &parameters,
                       const double target)
    {
      const double size          = std::abs(indicator);
      const std::string obstacle = effect.obstacle(parameters);
      if (obstacle.empty())
        return effect.is_free() || size > AccuracyBudget::effect(target, effect.times_as_long());
      if (size > target)
        throw ComputationError(
            "Effects/" + effect.name + " = auto: it would change the results by " +
            (std::isfinite(indicator)
                 ? per_cent(indicator) + ", more than the target, " + per_cent(target)
                 : "an amount that is not known, as no state of the motor was found") +
            ", but " + effect.switched_on() + obstacle + ", or a larger target");
      return false;
    }

    /** What an effect that is switched off would change is for information: its estimate may fail.
     */
    std::optional<double> indicator_of(const Effect &effect, const Scene &scene)
    {
      try
      {
        return effect.indicator(scene);
      }
      catch (const ComputationError &)
      {
        if (effect.choice(scene.parameters) != EffectChoice::off)
          throw;
        return {};
      }
    }
  } // namespace

  std::string Effect::obstacle_if_marched(const Parameters &parameters)
  {
    return is_marched(parameters) ? " is not available with Time/Scheme = marching or a warped "
                                    "ring in this version; allowed: off"
                                  : "";
  }

  std::string Effect::given(const Parameters &parameters) const
  {
    const EffectChoice chosen = choice(parameters);
    return "Effects/" + name + " = " +
           (chosen == EffectChoice::off  ? "off"
            : chosen == EffectChoice::on ? "on"
                                         : "auto");
  }

  const std::vector<EffectEntry> &effect_entries()
  {
    static const auto entries = entries_of<EffectEntry>(all_effects());
    return entries;
  }

  const PartList<Effect> &all_effects()
  {
    static const PartList<Effect> list = made_by<Effect>(
        {effects::tooth_shear, effects::rotor_tangential_compliance, effects::initial_deformation,
         effects::static_friction_excess, effects::rotor_inertia, effects::tooth_inertia,
         effects::stator_compliance, effects::tooth_vibration, effects::damping,
         effects::stator_back_reaction, effects::spin_convection, effects::target_plates,
         effects::felt_support, effects::piezoelectric_coupling, effects::friction_lining});
    return list;
  }

  MotorModel motor_model(const Parameters &parameters)
  {
    MotorModel model;
    model.friction                    = parameters.friction;
    model.friction.static_coefficient = model.friction.dynamic_coefficient;
    model.is_marched                  = parameters.time.scheme == TimeScheme::marching;
    for (const auto &effect : all_effects())
      if (effect->choice(parameters) != EffectChoice::off)
        effect->enter(parameters, model);
    // Without an excess all laws are this one, whose points have no memory.
    if (!has_static_excess(model.friction))
      model.friction.law = FrictionLaw("coulomb");
    return model;
  }

  bool is_marched(const Parameters &parameters)
  {
    return motor_model(parameters).is_marched;
  }

  MotorModel certain_model(Parameters parameters)
  {
    const Parameters given = parameters;
    for (const auto &effect : all_effects())
      if (effect->choice(given) == EffectChoice::automatic &&
          effect->indicator({given, nullptr, {}}))
        parameters.effects[effect->name] = EffectChoice::off;
    return motor_model(parameters);
  }

  namespace
  {
    /** A voltage makes a wave if the ceramic has a potential, and if the wave is steady. */
    void check_drive(const Parameters &parameters, const MotorModel &model)
    {
      if (parameters.wave.drive != Drive::voltage)
        return;
      const std::string given = "Wave/Drive = voltage ";
      if (!parameters.wave.voltage)
        throw UserError(given + "needs Wave/Voltage, found none; give it in V, zero to peak");
      if (!model.ceramic)
        throw UserError(given + "needs Effects/Piezoelectric coupling = on, found off, with which "
                                "electrodes exert no forces; allowed: on, auto, or Wave/Drive = "
                                "amplitude");
      if (model.is_marched)
        throw UserError(given +
                        "needs a steady state, but this motor is marched in time "
                        "(Time/Scheme = marching, or a warped ring), in which the amplitude "
                        "takes hundreds of periods to settle; allowed: Time/Scheme = steady "
                        "without Effects/Initial deformation, or Wave/Drive = amplitude");
    }

    void check_tangential_compliance(const Parameters &parameters, const MotorModel &model)
    {
      if (!model.teeth_give_way && !model.rotor_gives_way_along &&
          model.lining_tangential_compliance == 0. &&
          parameters.contact.formulation == ContactFormulation::mortar)
        throw UserError("Effects/Tooth shear = off and Effects/Rotor tangential compliance = off "
                        "leave no tangential compliance; allowed: one of them on or auto, or "
                        "Effects/Friction lining = on");
    }
  } // namespace

  void check_effects(const Parameters &parameters, const EffectStage last)
  {
    for (const auto &effect : all_effects())
      if (effect->stage <= last && effect->choice(parameters) != EffectChoice::off)
        effect->check(parameters);
    // Obstacles are those of a whole model, in which the entries of all effects are used.
    for (const auto &effect : all_effects())
      if (effect->stage <= last && effect->choice(parameters) == EffectChoice::on)
        if (const std::string obstacle = effect->obstacle(parameters); !obstacle.empty())
          throw UserError(effect->given(parameters) + obstacle);
    if (last == EffectStage::stator)
      return;
    check_drive(parameters, motor_model(parameters));
    check_tangential_compliance(parameters, certain_model(parameters));
  }

  std::vector<std::string> warnings_of_effects(const Parameters &parameters,
                                               const EffectStage stage)
  {
    std::vector<std::string> all;
    for (const auto &effect : all_effects())
      if (effect->stage == stage && effect->choice(parameters) != EffectChoice::off)
        for (const std::string &warning : effect->warnings(parameters))
          all.push_back(warning);
    return all;
  }

  namespace
  {
    /** Includes the largest effects that were left out as long as all of them together exceed
     * AccuracyBudget::left_out(); none where those that the motor cannot have do so alone. */
    void include_largest(std::vector<EffectRow> &rows, Parameters &parameters, const double target)
    {
      const auto can_be_included = [&](const EffectRow &row)
      {
        for (const auto &effect : all_effects())
          if (effect->name == row.name)
            return row.is_left_out() && effect->obstacle(parameters).empty();
        return false;
      };
      while (true)
      {
        double whole = 0., fixed = 0.; // of independent errors
        EffectRow *largest = nullptr;
        for (EffectRow &row : rows)
          if (row.is_left_out())
          {
            whole = std::hypot(whole, *row.indicator);
            if (!can_be_included(row))
              fixed = std::hypot(fixed, *row.indicator);
            else if (!largest || std::abs(*row.indicator) > std::abs(*largest->indicator))
              largest = &row;
          }
        const double limit = AccuracyBudget::left_out(target);
        if (whole <= limit || fixed > limit || !largest)
          return;
        parameters.effects[largest->name] = EffectChoice::on;
        largest->choice                   = "on";
      }
    }

    std::vector<const Effect *> in_order_of_choice(const EffectStage stage)
    {
      std::vector<const Effect *> effects;
      for (const bool last : {false, true})
        for (const auto &effect : all_effects())
          if (effect->stage == stage && effect->is_chosen_last() == last)
            effects.push_back(effect.get());
      return effects;
    }
  } // namespace

  std::vector<EffectRow> choose_effects(Parameters &parameters, const EffectStage stage,
                                        const Scene &scene, const double target)
  {
    Scene whole     = scene;
    whole.threshold = AccuracyBudget::effect(target);
    // Rayleigh quotients are cheap, operating points are not.
    Scene cheap = whole;
    if (stage != EffectStage::stator)
      cheap.measure = {};
    std::vector<EffectRow> rows;
    for (const Effect *effect : in_order_of_choice(stage))
    {
      const auto begin          = std::chrono::steady_clock::now();
      const EffectChoice choice = effect->choice(parameters);
      EffectRow row{effect->name, {}, choice == EffectChoice::off ? "off" : "on"};
      row.is_automatic = choice == EffectChoice::automatic;
      row.indicator    = indicator_of(*effect, row.is_automatic ? whole : cheap);
      if (row.is_automatic && row.indicator)
      {
        const bool is_on = auto_includes(*effect, *row.indicator, parameters, target);
        parameters.effects[effect->name] = is_on ? EffectChoice::on : EffectChoice::off;
        row.choice                       = is_on ? "on" : "off";
      }
      if (row.indicator && !std::isfinite(*row.indicator)) // needed, of unknown size
        row.indicator.reset();
      row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      rows.push_back(std::move(row));
    }
    include_largest(rows, parameters, target);
    return rows;
  }

  void add_costs(const CondensedMotor &motor, std::vector<EffectRow> &rows)
  {
    for (EffectRow &row : rows)
      for (const auto &effect : all_effects())
        if (effect->name == row.name)
          effect->add_cost(motor, row);
  }

  void add_modes_to(EffectRow &row, const CondensedMotor &motor, const ModePart part)
  {
    for (const RingModes *modes :
         {&motor.modes, &motor.coarse_modes, &motor.modes_of_other_harmonics})
      for (const std::vector<RingMode> &of_diameter : *modes)
        for (const RingMode &mode : of_diameter)
          if (mode.part == part &&
              (part != ModePart::tooth || mode.response == ModeResponse::vibrates))
          {
            row.dofs += modes == &motor.modes ? 1 : 0;
            row.bytes += mode.motion.size() * sizeof(mode.motion.front());
          }
  }
} // namespace ringmotor
