// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

// The search for the amplitude and for the frequency of a wave with the rotor on the stator: both
// change until an excess vanishes, and each trial is the search for a whole state of the motor.

namespace ringmotor
{
  /** A state at a place (of any unit), and the excess there: where it is negative, the place grows.
   */
  template <typename State>
  struct Trial
  {
    double place, excess;
    State state;
  };

  /** Where stable_root() looks, and how closely. */
  struct RootLimits
  {
    double longest; ///< move before both sides of the root are known
    double range;   ///< greatest distance from the start
    double narrow;  ///< distance of two places that count as the same
  };

  /** How a search for a root has ended. */
  enum class RootEnd
  {
    settled, ///< as the caller wanted
    jump,    ///< the excess changes its sign between two places that count as the same
    escaped, ///< beyond RootLimits::range
    endless  ///< too many trials
  };

  /** What stable_root() has found. */
  template <typename State>
  struct StableRoot
  {
    Trial<State> found; ///< with the smaller excess
    /** On the other side of the root, if one is known there, else that before. */
    std::optional<Trial<State>> other;
    RootEnd end = RootEnd::settled;

    bool is_enclosed() const { return other && (found.excess < 0.) != (other->excess < 0.); }

    /** By which share of the difference between both states #found may differ from that of the
     * root: at a jump all of it, otherwise by linear interpolation or extrapolation. */
    double share() const
    {
      if (!other)
        return 0.;
      const double difference = std::abs(found.excess - other->excess);
      return end == RootEnd::jump || difference <= std::abs(found.excess)
                 ? 1.
                 : std::abs(found.excess) / difference;
    }
  };

  /** Reduces an interval at whose ends @p excess differs in sign, by the algorithm 748 of Alefeld,
   * Potra and Shi (1995), until @p excess is zero or the interval is no longer than @p narrow.
   * @return whether the number of trials was enough */
  bool reduce_interval(const std::function<double(double)> &excess,
                       const std::pair<double, double> &one, const std::pair<double, double> &other,
                       const double narrow);

  /**
   * The place to which one moves from @p start if its speed is minus the excess, whose slope is
   * about one to begin with: a root at which the excess increases, or a jump from negative to
   * positive values. States may depend on those found before; each place is tried once.
   * @param at the excess and the state at a place
   * @param is_settled whether what is known of the root is enough
   */
  template <typename State>
  StableRoot<State> stable_root(const double start,
                                const std::function<std::pair<double, State>(double)> &at,
                                const std::function<bool(const StableRoot<State> &)> &is_settled,
                                const RootLimits &limits)
  {
    constexpr unsigned int most_moves = 60;
    constexpr double least_slope      = 0.05;
    std::optional<Trial<State>> last, growing, decaying;
    StableRoot<State> root;
    // Zero as soon as the root is settled, which ends the reduction of an interval.
    const auto excess = [&](const double place)
    {
      auto [value, state]                = at(place);
      std::optional<Trial<State>> before = std::move(last);
      last                               = Trial<State>{place, value, std::move(state)};
      (value < 0. ? growing : decaying)  = last;
      root.found                         = *last;
      root.other                         = before;
      if (growing && decaying)
      {
        const bool is_growing = std::abs(growing->excess) < std::abs(decaying->excess);
        root.found            = is_growing ? *growing : *decaying;
        root.other            = is_growing ? *decaying : *growing;
      }
      return is_settled(root) ? 0. : value;
    };
    double place = start, value = excess(place), slope = 1.;
    for (unsigned int move_number = 0; value != 0. && !root.is_enclosed(); ++move_number)
    {
      const double move = std::clamp(-value / slope, -limits.longest, limits.longest);
      place += move;
      if (move_number == most_moves || std::abs(place - start) > limits.range)
      {
        root.end = move_number == most_moves ? RootEnd::endless : RootEnd::escaped;
        return root;
      }
      const double before = value;
      value               = excess(place);
      slope               = std::max((value - before) / move, least_slope);
    }
    if (value == 0.)
      return root;
    root.end = reduce_interval(excess, {growing->place, growing->excess},
                               {decaying->place, decaying->excess}, limits.narrow)
                   ? (is_settled(root) ? RootEnd::settled : RootEnd::jump)
                   : RootEnd::endless;
    return root;
  }
} // namespace ringmotor
