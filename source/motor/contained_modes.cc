// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/contained_columns.h>
#include <ringmotor/motor/contained_modes.h>

namespace ringmotor
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Whether the residual compliance lacks its static motion. */
    bool is_subtracted(const RingMode &mode, const RingDynamics &dynamics)
    {
      const bool vibrates =
          mode.response == ModeResponse::vibrates && !(mode.of_rotor() && dynamics.is_hysteretic);
      return mode.at_once() > 0. && (vibrates || mode.response == ModeResponse::none);
    }

    /** The static motions of all that are subtracted, one after the other, for waves exp(i k j
     * alpha) of the compliance: those of modes travel the other way. */
    std::vector<Complex> static_motions(const std::vector<RingMode> &modes,
                                        const RingDynamics &dynamics)
    {
      std::vector<Complex> motions;
      for (const RingMode &mode : modes)
        if (is_subtracted(mode, dynamics))
          for (const std::array<Complex, 3> &motion : mode.motion)
            for (const Complex &component : motion)
              motions.push_back(std::conj(component) / mode.angular_frequency);
      return motions;
    }

    /** The inverse of static_motions(). */
    void set_static_motions(const std::vector<Complex> &motions, const RingDynamics &dynamics,
                            std::vector<RingMode> &modes)
    {
      auto next = motions.begin();
      for (RingMode &mode : modes)
        if (is_subtracted(mode, dynamics))
        {
          if (mode.of_rotor()) // for pictures
            mode.of_body = mode.motion;
          for (std::array<Complex, 3> &motion : mode.motion)
            for (Complex &component : motion)
              component = std::conj(*next++) * mode.angular_frequency;
        }
    }
  } // namespace

  RingModes contained_modes(RingModes modes, const RingCompliance &compliance,
                            const RingDynamics &dynamics)
  {
    for (unsigned int k = 0; k < modes.size(); ++k)
    {
      const std::vector<Complex> motions = static_motions(modes[k], dynamics);
      if (motions.empty())
        continue;
      const std::vector<Complex> contained =
          contained_columns(3 * compliance.n_nodes(), compliance.of_wave(k), motions);
      if (contained != motions)
        set_static_motions(contained, dynamics, modes[k]);
    }
    return modes;
  }
} // namespace ringmotor
