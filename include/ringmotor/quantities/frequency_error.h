// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace ringmotor
{
  /** A number with its error bar, in the same unit. */
  struct Estimate
  {
    double value = 0.;
    double error = 0.;
  };

  /** What one computation on one mesh says of a mode's frequency. */
  struct FrequencySample
  {
    unsigned int degree; ///< of the finite elements
    double frequency;    ///< Hz, as computed: never below the exact one for a conforming mesh
    double indicator;    ///< sum of sheet_indicators() of the mode
  };

  /**
   * The frequency with its error bar from the computations done so far, the last one being the
   * best.
   *
   * The relative excess of a computed eigenvalue is a multiple kappa of the indicator. At slot
   * roots and free edges, where the indicator's energy sits, kappa depends on the polynomial degree
   * but hardly on the mesh: between 0.09 and 0.14 (degree 2), 0.2 and 0.41 (3), 0.48 and 0.72 (4)
   * on stator meshes whose exact frequency is known; where the solution is smooth it is smaller.
   * The larger of kappa = 0.3 p - 0.45 and what two computations of one degree show is taken as the
   * bound: the exact frequency then lies between the computed one and kappa/2 indicators below it.
   * The value is the middle, the error half the width.
   */
  Estimate frequency_estimate(const std::vector<FrequencySample> &samples);

  /**
   * A quantity of the mode's shape with its error bar: @p value on the last mesh, @p earlier on the
   * one before, and the indicators there. The change between the meshes, scaled by what is left of
   * the indicator, and doubled because such quantities need not converge from one side.
   */
  Estimate shape_estimate(const double value, const double earlier, const double indicator,
                          const double earlier_indicator);
} // namespace ringmotor
