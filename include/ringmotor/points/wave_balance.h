// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/stable_root.h>

#include <cmath>
#include <functional>
#include <utility>

// The searches for what the contact and a voltage make of the wave. They are nested: each trial of
// an amplitude is the search for a frequency, each trial of a frequency that for a steady state.
// All end by one rule, see balanced().

namespace ringmotor
{
  /** An unknown of the wave with the rotor on the stator. */
  struct WaveUnknown
  {
    RootLimits limits;
    /** @param other_excess that beyond the root, if it is enclosed
     * @throws ComputationError if a search has not ended at a balance */
    void (*require_settled)(const RootEnd end, const double start, const double place,
                            const double excess, const double other_excess);
  };

  /** The frequency to which the contact shifts a wave, over that without contact; its excess is
   * the difference from that which the state there has. */
  extern const WaveUnknown shifted_frequency;

  /** The logarithm of the amplitude (m) of a driven wave; its excess, see VoltageDrive::excess(),
   * has a slope of about one: the force of the voltage over that of dampers and springs falls with
   * the amplitude to a power of about one. As the search follows its sign, the amplitude found is
   * stable. */
  extern const WaveUnknown driven_amplitude;

  /** The excess of a driven amplitude that may remain where the forces of the contact jump from one
   * state to a neighbouring one, as with static friction above dynamic friction. */
  inline constexpr double largest_excess_of_drive = 1e-2;

  /**
   * The balance of an unknown. The search ends where the excess vanishes to rounding, or where the
   * states of the last two places differ so little that what is left of the search is negligible.
   * @param at the excess of a place, and the state there
   * @param is_negligible whether StableRoot::share() of the difference between both states is
   * @throws ComputationError by WaveUnknown::require_settled
   */
  template <typename State>
  StableRoot<State> balanced(const WaveUnknown &unknown, const double start,
                             const std::function<std::pair<double, State>(double)> &at,
                             const std::function<bool(const StableRoot<State> &)> &is_negligible)
  {
    constexpr double vanishing   = 1e-8;
    const StableRoot<State> root = stable_root<State>(
        start, at,
        [&](const StableRoot<State> &so_far) {
          return std::abs(so_far.found.excess) <= vanishing ||
                 (so_far.other && is_negligible(so_far));
        },
        unknown.limits);
    unknown.require_settled(root.end, start, root.found.place, root.found.excess,
                            root.other ? root.other->excess : 0.);
    return root;
  }
} // namespace ringmotor
