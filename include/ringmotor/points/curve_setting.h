// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/parameters/parameters.h>

#include <string>
#include <tuple>

namespace ringmotor
{
  /** In which modes bodies vibrate: those requested, or others that measure their error, see
   * RotorVibration. */
  enum class ModesInUse
  {
    requested,
    coarse,            ///< on the next coarser mesh
    of_other_harmonics ///< on that mesh
  };

  /** How finely bodies and time are divided. */
  struct CurveSetting
  {
    unsigned int level = 0; ///< of the meshes, see ContactDiscretisation::level()
    /** Into how many parts a step is divided: the time samples of the steady state, or the parts of
     * Time/Time step. */
    unsigned int n_parts = 1;
    /** How many steps are joined into one, see SteadyStep for those of the steady state: such long
     * steps give the error of a step without more unknowns, or with half the work. */
    unsigned int n_joined = 1;
    /** Factor on the speed of the stator's surface, to measure the effect of its error. */
    double wave_factor = 1.;
    /** The modes of bodies with inertia. */
    ModesInUse modes = ModesInUse::requested;
    /** Whether the time integration of inertia has another dissipation, to measure its effect. */
    bool has_other_scheme = false;
    /** Whether a driven wave is the largest that the errors of its drive allow. */
    bool has_drive_error = false;

    /** Whether a marched point must report the error of the averaging window of `Time`. Not
     * compared: a point that has it also serves where it is not needed. */
    bool tells_window = false;

    bool operator<(const CurveSetting &other) const
    {
      return std::tie(level, n_parts, n_joined, wave_factor, modes, has_other_scheme,
                      has_drive_error) < std::tie(other.level, other.n_parts, other.n_joined,
                                                  other.wave_factor, other.modes,
                                                  other.has_other_scheme, other.has_drive_error);
    }

    bool operator==(const CurveSetting &other) const
    {
      return !(*this < other) && !(other < *this);
    }

    /** Steps in the time of an undivided one: that after which a tooth is in the state of another
     * one, or `Time/Time step`. */
    double n_steps() const { return n_parts / static_cast<double>(n_joined); }

    /** Whether its motor differs from the requested one: by another wave, other modes, another
     * scheme or another drive. */
    bool has_changed_motor() const
    {
      return wave_factor != 1. || modes != ModesInUse::requested || has_other_scheme ||
             has_drive_error;
    }

    /** All of it in words, to distinguish settings: "interface mesh 1, step 1/2". */
    std::string text() const;

    /** The same with steps of half the length. */
    CurveSetting halved() const;
    /** The same with steps of twice the length; time samples must be even in number, or a single
     * one. */
    CurveSetting doubled() const;
  };

  /** The choice of steps for one motor. */
  class StepChoice
  {
  public:
    /** @param period s, of the wave */
    StepChoice(const Parameters &parameters, const double period);

    /** The setting with which meshes, waves and averaging windows are compared: the same steps on
     * all meshes, and no more than necessary. */
    CurveSetting plain(const unsigned int level) const;

    /** The setting with which the search for points begins on a mesh, from those of another mesh:
     * plain() or a multiple of its steps. A search is short from a state with longer steps. */
    CurveSetting longest(const unsigned int level) const;

    /** The initial CurveSetting::n_parts: `Time/Snapshots` of the steady state, or more if steps
     * must not be too long, and then those of plain() or shorter ones. */
    unsigned int first_parts() const;

    /** The largest CurveSetting::n_parts that is tried. */
    unsigned int most_parts() const;

  private:
    /** Parts of a step such that a period has at least @p n_steps steps. */
    unsigned int parts_for(const unsigned int n_steps) const;

    const bool is_marched, is_fixed;
    const unsigned int n_snapshots;
    const unsigned int few_steps; ///< in a period of the steady state
    const double n_undivided;     ///< steps in a period, neither divided nor joined
  };
} // namespace ringmotor
