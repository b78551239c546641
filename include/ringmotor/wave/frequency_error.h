// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/results/estimate.h>

namespace ringmotor
{
  /** The cause of an error. */
  inline constexpr const char *by_body_mesh = "body mesh";

  /** The result of one computation on one mesh for a mode's frequency. */
  struct FrequencySample
  {
    unsigned int degree; ///< of the finite elements
    double frequency;    ///< Hz, as computed: never below the exact one for a conforming mesh
    double indicator;    ///< sum of sheet_indicators() of the mode
  };

  /**
   * The frequency with its error bar, whose cause is the body mesh.
   *
   * The relative excess of a computed eigenvalue is kappa times the indicator. On sectors of three
   * different stators and four rotors (with and without bars, flange solid or shell; 8 modes of 0
   * to 7 waves each, against meshes with a hundredth of the error) kappa was at most 0.98 for
   * degree 2, 2.9 for degree 3 and 2.1 for degree 4, and mostly half of that. A tenth or more is
   * added to these. The exact frequency then lies between the computed one and kappa/2 indicators
   * below it; the value is the middle, the error half the width.
   *
   * Not covered: with degree 2, a motion that is exactly odd within each cell of a sheet, so that
   * its quadratic part vanishes.
   */
  Estimate frequency_estimate(const FrequencySample &sample);

  /**
   * A quantity of the mode's shape with its error bar: @p value on the last mesh, @p earlier on the
   * one before, and the samples of the frequency there. The error is the change between the meshes,
   * scaled to what remains of it (the shape converges at worst like the square root of the
   * indicator) and doubled, as such quantities need not converge from one side. Since a change can
   * be small by accident, the error bar is at least that of the eigenvalue,
   * 2 * @p relative_frequency_error, to which energies and ratios of amplitudes are tied.
   */
  Estimate shape_estimate(const double value, const double earlier, const FrequencySample &sample,
                          const FrequencySample &earlier_sample,
                          const double relative_frequency_error);
} // namespace ringmotor
