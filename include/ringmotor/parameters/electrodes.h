// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

namespace dealii
{
  class ParameterHandler;
}

namespace ringmotor
{
  /** The electrode arcs under the ceramic: two phases, each a row of arcs that are half a wave long
   * and poled alternately. The upper electrode is the metal of the stator. */
  struct Electrodes
  {
    std::optional<unsigned int> n_arcs_a, n_arcs_b; ///< none: one less than the waves of the motor
    double phase_distance = 0.25; ///< wavelengths from the end of phase A to the start of phase B
    double arc_gap        = 5e-4; ///< m, without metal between two arcs, at the mean radius

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };
} // namespace ringmotor
