// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/contained_columns.h>
#include <ringmotor/motor/contained_modes.h>

#include <optional>

namespace ringmotor
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Whether the residual compliance lacks its static motion. */
    bool is_subtracted(const RingMode &mode, const RingDynamics &dynamics)
    {
      return mode.at_once() > 0. && (dynamics.gives_inertia_to(mode.part, mode.response) ||
                                     mode.response == ModeResponse::none);
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

  void contain_modes(const std::vector<RingModes *> &sets, const RingCompliance &compliance,
                     const RingDynamics &dynamics)
  {
    for (unsigned int k = 0; 2 * k <= compliance.n_sectors(); ++k)
    {
      std::optional<const ContainedColumns> of_compliance; // for all sets, if any has modes
      for (RingModes *const modes : sets)
      {
        const std::vector<Complex> motions =
            modes->empty() ? std::vector<Complex>() : static_motions((*modes)[k], dynamics);
        if (motions.empty())
          continue;
        if (!of_compliance)
          of_compliance.emplace(3 * compliance.n_nodes(), compliance.of_wave(k));
        const std::vector<Complex> contained = of_compliance->nearest_to(motions);
        if (contained != motions)
          set_static_motions(contained, dynamics, (*modes)[k]);
      }
    }
  }
} // namespace ringmotor
