// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/wave_balance.h>

#include <cmath>

namespace ringmotor
{
  namespace
  {
    void require_frequency(const RootEnd end, const double, const double place, const double excess,
                           const double)
    {
      if (end == RootEnd::escaped || end == RootEnd::endless)
        throw ComputationError("the frequency of the wave with the rotor on the stator did not "
                               "settle; at " +
                               short_text(place) + " times that without rotor it is off by " +
                               short_text(-excess) +
                               ": choose shorter steps (a larger Time/Snapshots), or "
                               "Effects/Stator back-reaction = off");
    }

    void require_amplitude(const RootEnd end, const double start, const double place,
                           const double excess, const double other_excess)
    {
      const std::string at = short_text(std::exp(place)) + " m";
      if (end == RootEnd::endless)
        throw ComputationError("the amplitude of the wave did not settle; at " + at +
                               " its forces are out of balance by " + short_text(excess));
      if (end == RootEnd::escaped)
        throw ComputationError("the wave " + std::string(place < start ? "decays" : "grows") +
                               " beyond " + at +
                               " without a balance of its forces; choose another Wave/Voltage, "
                               "Wave/Frequency or load");
      if (end == RootEnd::jump && std::abs(excess) > largest_excess_of_drive)
        throw ComputationError("no amplitude balances the voltage: at " + at +
                               " the forces of the contact on the wave jump by " +
                               short_text(std::abs(other_excess - excess)) +
                               "; choose shorter steps (a larger Time/Snapshots) or another "
                               "Wave/Voltage");
    }
  } // namespace

  const WaveUnknown shifted_frequency{{0.1, 0.5, 1e-7}, require_frequency};
  const WaveUnknown driven_amplitude{{0.4, 4.6 /* a hundred times */, 3e-6}, require_amplitude};
} // namespace ringmotor
