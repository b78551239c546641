// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/parameters/parameters.h>

#include <string>
#include <tuple>

namespace ringmotor
{
  /** How finely bodies and time are divided. */
  struct CurveSetting
  {
    unsigned int level = 0; ///< of the meshes, see ContactDiscretisation::level()
    /** Into how many parts a step is divided: the samples of the steady state, or the parts of
     * Time/Time step. */
    unsigned int n_parts = 1;
    /** How many steps are joined to one, see SteadyStep for those of the steady state: such long
     * steps tell without more unknowns, or with half the work, how large the error of a step is. */
    unsigned int n_joined = 1;
    /** Factor of the speed of the stator's surface, by which its error is felt. */
    double wave_factor = 1.;
    /** Whether a rotor with inertia vibrates in its coarse modes, by which their error is felt. */
    bool has_coarse_modes = false;
    /** Whether the scheme that steps what has inertia dissipates otherwise, by which that is felt.
     */
    bool has_other_scheme = false;
    /** Whether a marched point has to tell what the steps miss that `Time` averages over. Not
     * compared: a point that tells it will do for one that need not. */
    bool tells_window = false;

    bool operator<(const CurveSetting &other) const
    {
      return std::tie(level, n_parts, n_joined, wave_factor, has_coarse_modes, has_other_scheme) <
             std::tie(other.level, other.n_parts, other.n_joined, other.wave_factor,
                      other.has_coarse_modes, other.has_other_scheme);
    }

    bool operator==(const CurveSetting &other) const
    {
      return !(*this < other) && !(other < *this);
    }

    /** Steps in the time of an undivided one: in which a tooth comes to be where another one was,
     * or `Time/Time step`. */
    double n_steps() const { return n_parts / static_cast<double>(n_joined); }

    /** Whether its motor is not quite the one that is asked for: of another wave, with other modes
     * or another scheme. */
    bool has_changed_motor() const
    {
      return wave_factor != 1. || has_coarse_modes || has_other_scheme;
    }

    /** All of it in words, by which settings are told apart: "interface mesh 1, step 1/2". */
    std::string text() const;

    /** The same with steps of half the length. */
    CurveSetting halved() const;
  };

  /** Which steps one motor is computed with. */
  class StepChoice
  {
  public:
    /** @param period s, of the wave */
    StepChoice(const Parameters &parameters, const double period);

    /** With which meshes, waves and averaging windows are compared: the same steps on all meshes,
     * and not more of them than necessary. */
    CurveSetting plain(const unsigned int level) const;

    /** CurveSetting::n_parts to begin with: `Time/Snapshots` of the steady state, or so many that
     * steps are shorter than those of plain() and not too long. */
    unsigned int first_parts() const;

    /** Up to which CurveSetting::n_parts are tried. */
    unsigned int most_parts() const;

  private:
    /** Parts of a step so that a period has so many steps or more. */
    unsigned int parts_for(const unsigned int n_steps) const;

    const bool is_marched, is_fixed;
    const unsigned int n_snapshots;
    const unsigned int few_steps; ///< in a period of the steady state
    const double n_undivided;     ///< steps in a period, neither divided nor joined
  };
} // namespace ringmotor
