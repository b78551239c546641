// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/stable_root.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace ringmotor
{
  /** The search for the frequency to which the contact shifts a wave, over that without contact. */
  namespace shifted_wave
  {
    inline constexpr RootLimits limits{0.1, 0.5, 1e-7};
    /** The excess that counts as none. */
    inline constexpr double settled = 1e-8;

    /** @throws ComputationError if there is no such frequency within the limits */
    void require_settled(const RootEnd end, const double place, const double excess);
  } // namespace shifted_wave

  /** The search for the amplitude of a driven wave. Places are logarithms of amplitudes (m), so
   * that the excess has a slope of about one: the force of the voltage over that of dampers and
   * springs falls with the amplitude to a power of about one. */
  namespace driven_wave
  {
    inline constexpr RootLimits limits{0.4, 4.6 /* a hundred times */, 3e-6};
    /** The excess that may remain where the forces of the contact jump from one state to a
     * neighbouring one, as with static friction above dynamic friction. */
    inline constexpr double largest_excess = 1e-2;

    /** @param excess the smaller one @param width of the interval that encloses the root, infinite
     * if there is none */
    bool is_balanced(const double excess, const double width);

    /** @throws ComputationError if the wave grew or decayed for ever, or the excess jumps from @p
     * excess at @p place to one as large beyond it */
    void require_balance(const RootEnd end, const double start, const double place,
                         const double excess, const double beyond);
  } // namespace driven_wave

  /**
   * The amplitude to which a driven wave grows or decays from @p start (m): where its excess
   * vanishes, see VoltageDrive::excess(). As the search follows the sign of the excess, the balance
   * that it finds is one in which the amplitude is stable.
   * @param at the excess of an amplitude (m), and the state there
   * @return StableRoot by logarithms of the amplitude
   * @throws ComputationError if the amplitude does not settle between a hundredth and a hundred
   * times @p start, or if the excess jumps by more than driven_wave::largest_excess
   */
  template <typename State>
  StableRoot<State> balanced_amplitude(const double start,
                                       const std::function<std::pair<double, State>(double)> &at)
  {
    const auto width = [](const StableRoot<State> &root)
    {
      return root.is_enclosed() ? std::abs(root.found.place - root.other->place)
                                : std::numeric_limits<double>::infinity();
    };
    const StableRoot<State> root = stable_root<State>(
        std::log(start), [&](const double place) { return at(std::exp(place)); },
        [&](const StableRoot<State> &so_far)
        { return driven_wave::is_balanced(std::abs(so_far.found.excess), width(so_far)); },
        driven_wave::limits);
    driven_wave::require_balance(root.end, start, std::exp(root.found.place), root.found.excess,
                                 root.other ? root.other->excess : 0.);
    return root;
  }
} // namespace ringmotor
