// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/wave_balance.h>

#include <cmath>

namespace ringmotor
{
  void shifted_wave::require_settled(const RootEnd end, const double place, const double excess)
  {
    if (end == RootEnd::escaped || end == RootEnd::endless)
      throw ComputationError("the frequency of the wave with the rotor on the stator did not "
                             "settle; at " +
                             short_text(place) + " times that without rotor it is off by " +
                             short_text(-excess) +
                             ": choose shorter steps (a larger Time/Snapshots), or "
                             "Effects/Stator back-reaction = off");
  }

  bool driven_wave::is_balanced(const double excess, const double width)
  {
    // Beside a change of the state of a contact node the forces jump a little.
    constexpr double settled = 1e-5, small_jump = 3e-4, narrow_for_it = 1e-4;
    return excess <= settled || (excess < small_jump && width < narrow_for_it);
  }

  void driven_wave::require_balance(const RootEnd end, const double start, const double place,
                                    const double excess, const double beyond)
  {
    if (end == RootEnd::endless)
      throw ComputationError("the amplitude of the wave did not settle; at " + short_text(place) +
                             " m its forces are out of balance by " + short_text(excess));
    if (end == RootEnd::escaped)
      throw ComputationError("the wave " + std::string(place < start ? "decays" : "grows") +
                             " beyond " + short_text(place) +
                             " m without a balance of its forces; choose another Wave/Voltage, "
                             "Wave/Frequency or load");
    if (end == RootEnd::jump && std::abs(excess) > largest_excess)
      throw ComputationError("no amplitude balances the voltage: at " + short_text(place) +
                             " m the forces of the contact on the wave jump by " +
                             short_text(std::abs(beyond - excess)) +
                             "; choose shorter steps (a larger Time/Snapshots) or another "
                             "Wave/Voltage");
  }
} // namespace ringmotor
