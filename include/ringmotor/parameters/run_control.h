// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace ringmotor
{
  enum class AccuracyMode
  {
    adaptive, ///< refine until the estimated error is below the target
    fixed     ///< take degree and refinements as given
  };

  /** The names of the quantities of operating points whose error bars can be held below a target,
   * as in all outputs. */
  const std::vector<std::string> &held_quantities();

  /** The admissible error of one of them. */
  struct QuantityTarget
  {
    std::string quantity;
    std::optional<double> target; ///< relative; none: Accuracy::contact_target
  };

  /** How accurate the results must be, or how they are computed. */
  struct Accuracy
  {
    double target         = 1.e-4; ///< relative error of the results
    double contact_target = 0.1;   ///< relative error of #quantities
    std::vector<QuantityTarget> quantities{{"speed", {}}, {"torque", {}}};
    std::optional<double> time_limit; ///< s, for a run of stator or contact
    AccuracyMode mode                 = AccuracyMode::adaptive;
    unsigned int polynomial_degree    = 3; ///< mode fixed only
    unsigned int refinement           = 0; ///< of the body meshes, mode fixed only
    unsigned int interface_refinement = 0; ///< of the contact interface, mode fixed only
    unsigned int rotor_modes          = 2; ///< level of RotorVibration, mode fixed only

    /** The target of one of #quantities. */
    double target_of(const QuantityTarget &held) const
    {
      return held.target.value_or(contact_target);
    }
    /** The least target of all #quantities. */
    double strictest_target() const;
    /** The #quantities in words: "speed, torque". */
    std::string names_of_quantities() const;

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };

  /** How well the inputs of a motor are known: relative standard deviations. The programs compute
   * the motor as it is given; scripts/sweep.py draws samples of uncertain motors. */
  struct Uncertainty
  {
    double loss_factors = 0.; ///< of each material
    double friction     = 0.; ///< of both coefficients together
    double young_moduli = 0.; ///< of each material

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };

  enum class EffectChoice
  {
    off,
    on,
    automatic ///< on where its indicator exceeds the accuracy target
  };

  /** An entry of the section Effects. */
  struct EffectEntry
  {
    std::string name, sentence; ///< and its documentation
    EffectChoice unless_given = EffectChoice::automatic;
    bool has_auto             = true;
    /** `auto` means off for a motor without any of the entries that start with this; empty: it does
     * not depend on such entries. */
    std::string needs = {};
  };

  /** All of them, in their order. Each effect declares its own: this function is that of the room
   * that models them, see motor/effect.h. */
  const std::vector<EffectEntry> &effect_entries();

  /** Which physical effects are included. A file that does not mention them gets what its motor
   * and targets call for. */
  class Effects
  {
  public:
    Effects();

    /** The choice for the entry of a name. */
    EffectChoice &operator[](const std::string &name);
    EffectChoice operator[](const std::string &name) const;

    /** Declares the entries; reading them changes the choices. */
    void declare(dealii::ParameterHandler &prm);

  private:
    std::map<std::string, EffectChoice> choices;
  };

  /** A place on the tooth tops. */
  struct HistoryPoint
  {
    double tooth;  ///< angle in pitches of the teeth: 0 is the centre of tooth 0
    double radius; ///< m
  };

  /** Which results are written, and where. */
  struct Output
  {
    /**
     * Folder of the case; each program writes into its own folder below. read_parameters() replaces
     * `auto` by output/ and the name of the parameter file.
     */
    std::string directory          = "auto";
    bool vtu                       = true;    ///< write files for ParaView
    unsigned int frames_per_period = 16;      ///< of the animated wave
    bool figures                   = true;    ///< draw figures at the end of a run
    std::vector<HistoryPoint> history_points; ///< empty: the outer edge of tooth 0

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };
} // namespace ringmotor
