// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/quantities/chosen_effects.h>

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
  } // namespace

  ChosenEffects::ChosenEffects(const Parameters &given, const StatorWave &wave)
      : uniform_vibration(on_uniform_ring(given), wave.angular_frequency, MPI_COMM_WORLD),
        chosen(given), own_vibration(uniform_vibration)
  {
    constexpr unsigned int n_harmonics = 6, level = 1;
    // Where inertia was switched off, its estimate is for information only.
    constexpr unsigned int n_rough = 3, coarsest = 0;
    std::optional<LipAmplification> rough_lip;
    const Scene scene{
        chosen, &wave,
        [&](const Effect &effect)
        {
          measured[effect.name] =
              effect_on_points(chosen, effect, wave, uniform_vibration, MPI_COMM_WORLD);
          return measured[effect.name].relative;
        },
        [&]() -> const LipAmplification &
        {
          if (given.effects.rotor_inertia == EffectChoice::off)
            return rough_lip.emplace(given, uniform_vibration.roughly(n_rough), coarsest, n_rough);
          return lip.emplace(given, uniform_vibration.of_first_harmonics(), level, n_harmonics);
        }};
    rows = choose_effects(chosen, EffectStage::contact, scene, given.accuracy.contact_target);
    own_vibration = is_marched(chosen)
                        ? RotorVibration(chosen, wave.angular_frequency, MPI_COMM_WORLD)
                        : uniform_vibration; // with its computed results
  }
} // namespace ringmotor
