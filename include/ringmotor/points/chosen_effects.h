// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/lip_amplification.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/points/effect_on_points.h>
#include <ringmotor/results/quantity.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** The decisions on contact effects set to `auto`, and what was computed for them. */
  class ChosenEffects
  {
  public:
    /** @throws ComputationError if an effect is needed that is not available */
    ChosenEffects(const Parameters &given, const StatorWave &wave);

    /** The given parameters with all `auto` effects of the contact decided. */
    const Parameters &parameters() const { return chosen; }
    /** The effects left out, for error bars. */
    LeftOut left_out() const { return {rows, measured}; }
    /** The modes of the bodies of this motor. */
    const MotorVibration &vibration() const { return own_vibration; }

    std::optional<LipAmplification> lip; ///< if the rotor's inertia may matter
    /** What it tells of the rotor, with errors: `lip_A_r/A_n` and, with the number of the harmonic
     * of the wave, `lip_amplification_1`; empty without #lip. */
    std::vector<Quantity> lip_quantities;
    std::vector<EffectRow> rows;

  private:
    const MotorVibration uniform_vibration;         ///< on a uniform ring
    std::map<std::string, EffectOnPoints> measured; ///< effects measured at operating points
    Parameters chosen;
    MotorVibration own_vibration;
  };
} // namespace ringmotor
