// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/motor_model.h>
#include <ringmotor/parameters/part_list.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  class Effect;
  struct EffectRow;
  class LipAmplification;
  struct CondensedMotor;
  struct StatorWave;

  /** A motor before it is computed, for which effects estimate how much they matter. */
  struct Scene
  {
    const Parameters &parameters;
    const StatorWave *wave = nullptr; ///< if it is already known
    /** Computes the relative change of the results by an effect that cannot estimate it beforehand;
     * empty where the computation would cost more than it is worth. */
    std::function<double(const Effect &)> measure;
    /** The rotor's, which takes a second to compute; may be empty, too. */
    /** @param roughly for information only */
    std::function<const LipAmplification &(bool roughly)> lip = {};
    double threshold = 0.; ///< relative change above which `auto` includes an effect
  };

  /** The program that includes an effect; later programs need the results of earlier ones. */
  enum class EffectStage
  {
    stator, ///< in its modes
    contact
  };

  /**
   * A physical effect: its entry in the section Effects, what it needs, what it adds to the model
   * of a motor, and how much it matters. There is one class for each in motor/effects;
   * all_effects() is the list.
   */
  class Effect
  {
  public:
    Effect(const EffectEntry &entry, const EffectStage stage)
        : entry(entry), name(entry.name), stage(stage)
    {
    }
    virtual ~Effect() = default;

    /** Checks the entries that it needs; called unless it is off. @throws UserError */
    virtual void check(const Parameters &) const {}
    /** Choices that are allowed but easily misread, one line each; asked for unless it is off. */
    virtual std::vector<std::string> warnings(const Parameters &) const { return {}; }

    /** Why this motor cannot have it, and what is allowed instead, as the end of a sentence: ` is
     * not available with X; allowed: off`. Empty if it can. Such an effect is refused where it is
     * asked for, and where `auto` finds that it would be needed. */
    virtual std::string obstacle(const Parameters &) const { return ""; }

    /** Adds it to the model. */
    virtual void enter(const Parameters &parameters, MotorModel &model) const = 0;

    /** Sets the entries that only this effect reads to their defaults. */
    virtual void forget(Parameters &) const {}

    /** The relative change of speeds and torques, or of frequencies, due to it; none if it is part
     * of every contact and `auto` always means `on`. */
    virtual std::optional<double> indicator(const Scene &) const { return {}; }

    /** Whether it adds no work: then `auto` includes it, however small it is. */
    virtual bool is_free() const { return false; }

    /** By what it multiplies the time of each point, about: the more, the more of it `auto` leaves
     * to the error bars, see AccuracyBudget::effect(). */
    virtual double times_as_long() const { return 1.; }

    /** Whether it is measured with all others as they have been chosen. */
    virtual bool is_chosen_last() const { return false; }

    /** Time/Snapshots of the operating points by which it is measured. */
    virtual unsigned int n_snapshots_to_measure() const { return 1; }

    /** Adds what it costs a motor that has it to a row. */
    virtual void add_cost(const CondensedMotor &, EffectRow &) const {}

    EffectChoice choice(const Parameters &parameters) const { return parameters.effects[name]; }
    /** `Effects/Rotor inertia = auto`, with the given choice. */
    std::string given(const Parameters &parameters) const;
    /** The same with the choice `on`. */
    std::string switched_on() const { return "Effects/" + name + " = on"; }

    const EffectEntry entry;
    const std::string name; ///< of the entry
    const EffectStage stage;

  protected:
    /** The obstacle() of an effect that exists in the steady state only. */
    static std::string obstacle_if_marched(const Parameters &parameters);

    /** An indicator that only a computation can give. */
    std::optional<double> measured_in(const Scene &scene) const
    {
      return scene.measure ? std::optional<double>(scene.measure(*this)) : std::nullopt;
    }
  };

  /** All of them, in the order of the entries. */
  const PartList<Effect> &all_effects();

  /** The model without effects that `auto` may leave out by a formula of the parameters. */
  MotorModel certain_model(Parameters parameters);

  /** Checks all effects up to a stage that are not off, and the model that they make. @throws
   * UserError */
  void check_effects(const Parameters &parameters, const EffectStage last);

  /** The warnings of all effects of a stage that are not off. */
  std::vector<std::string> warnings_of_effects(const Parameters &parameters,
                                               const EffectStage stage);

  /** The decision on an effect in a run, and its cost. */
  struct EffectRow
  {
    std::string name;
    std::optional<double> indicator; ///< estimated relative change of the results
    std::string choice;              ///< "on" or "off"
    bool is_automatic   = false;     ///< chosen by the program
    double seconds      = 0.;        ///< to estimate and to include it
    std::uint64_t dofs  = 0;         ///< that it added
    std::uint64_t bytes = 0;         ///< that it added

    /** Whether the program has left it out, with a known indicator. */
    bool is_left_out() const { return is_automatic && choice == "off" && indicator; }
  };

  /**
   * Switches effects of a stage that are `auto` on or off: on where they are free, or the indicator
   * exceeds AccuracyBudget::effect() of @p target; one that the motor cannot have is off up to the
   * whole target. The largest of those left out follow as long as all of them together exceed
   * AccuracyBudget::left_out().
   * @return a row for each effect of the stage
   * @throws ComputationError if one is not available that changes more
   */
  std::vector<EffectRow> choose_effects(Parameters &parameters, const EffectStage stage,
                                        const Scene &scene, const double target);

  /** Adds what effects cost a motor to their rows, see Effect::add_cost(). */
  void add_costs(const CondensedMotor &motor, std::vector<EffectRow> &rows);

  enum class ModePart;

  /** Adds the modes of a part to a row. */
  void add_modes_to(EffectRow &row, const CondensedMotor &motor, const ModePart part);
} // namespace ringmotor
