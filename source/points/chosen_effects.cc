// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/points/chosen_effects.h>

#include <cmath>

namespace ringmotor
{
  namespace
  {
    /** The same motor without a warp, in its steady state. */
    Parameters on_uniform_ring(const Parameters &parameters)
    {
      Parameters uniform  = parameters;
      uniform.time.scheme = TimeScheme::steady;
      return uniform;
    }

    /** @param coarser the same on a coarser mesh: the whole difference is the error */
    std::vector<Quantity> quantities_of(const LipAmplification &lip,
                                        const LipAmplification &coarser,
                                        const double angular_frequency)
    {
      std::vector<Quantity> quantities;
      const auto add = [&](const std::string &name, const double value, const double on_coarser)
      {
        quantities.emplace_back(name, units::one,
                                Estimate(value, std::abs(value - on_coarser), "mesh of the rotor"));
      };
      add("lip_A_r/A_n", lip.radial_ratio(1, angular_frequency),
          coarser.radial_ratio(1, angular_frequency));
      for (unsigned int m = 1; m <= lip.n_harmonics(); ++m)
        add("lip_amplification_" + std::to_string(m), lip.at(m, m * angular_frequency),
            coarser.at(m, m * angular_frequency));
      return quantities;
    }
  } // namespace

  ChosenEffects::ChosenEffects(const Parameters &given, const StatorWave &wave)
      : uniform_vibration(on_uniform_ring(given), wave, MPI_COMM_WORLD), chosen(given),
        own_vibration(uniform_vibration)
  {
    constexpr unsigned int n_harmonics = 6, level = 1, coarsest = 0;
    // Where inertia was switched off, its estimate is for information only.
    constexpr unsigned int n_rough = 3;
    EffectsOnPoints on_points(wave, uniform_vibration, MPI_COMM_WORLD);
    std::optional<LipAmplification> rough_lip;
    const auto on_mesh = [&](const unsigned int mesh, const unsigned int n)
    { return LipAmplification(given, uniform_vibration.rotor.of_harmonics(n, mesh), mesh, n); };
    const Scene scene{chosen, &wave,
                      [&](const Effect &effect)
                      {
                        measured[effect.name] = on_points.of(effect, chosen);
                        return measured[effect.name].relative;
                      },
                      [&](const bool roughly) -> const LipAmplification &
                      {
                        if (roughly)
                          return rough_lip.emplace(on_mesh(coarsest, n_rough));
                        lip.emplace(on_mesh(level, n_harmonics));
                        lip_quantities = quantities_of(*lip, on_mesh(coarsest, n_harmonics),
                                                       wave.angular_frequency);
                        return *lip;
                      }};
    rows = choose_effects(chosen, EffectStage::contact, scene, given.accuracy.contact_target);
    own_vibration = is_marched(chosen) ? MotorVibration(chosen, wave, MPI_COMM_WORLD)
                                       : uniform_vibration; // with its computed results
  }
} // namespace ringmotor
