// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/lip_amplification.h>
#include <ringmotor/quantities/effect_on_points.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** What becomes of the effects of the contact that are `auto`, and what was computed to choose.
   */
  class ChosenEffects
  {
  public:
    /** @throws ComputationError if an effect is needed that is not available */
    ChosenEffects(const Parameters &given, const StatorWave &wave);

    /** Those given, with no effect of the contact `auto`. */
    const Parameters &parameters() const { return chosen; }
    /** What was left out, for error bars. */
    LeftOut left_out() const { return {rows, measured}; }
    /** The modes of the rotor of this motor. */
    const RotorVibration &vibration() const { return own_vibration; }

    std::optional<LipAmplification> lip; ///< if inertia of the rotor may take part
    std::vector<EffectRow> rows;

  private:
    const RotorVibration uniform_vibration;         ///< of the rotor on a uniform ring
    std::map<std::string, EffectOnPoints> measured; ///< effects that operating points tell
    Parameters chosen;
    RotorVibration own_vibration;
  };
} // namespace ringmotor
