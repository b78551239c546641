// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>
#include <ringmotor/quantities/energy.h>
#include <ringmotor/quantities/mode_search.h>
#include <ringmotor/quantities/surface_trace.h>
#include <ringmotor/quantities/tooth_motion.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** The motion of a named point of the tooth. */
  struct PointResult
  {
    ToothPoint point;
    EllipticMotion motion;
  };

  /** The motor's travelling wave at its amplitude: what the contact needs to know of the stator. */
  struct WaveResult
  {
    FoundMode found;                 ///< scaled to the wave's amplitude
    double angular_frequency = 0.;   ///< rad/s, of the forced motion
    double amplitude         = 0.;   ///< m, normal, at the outer edge of the tooth top
    std::vector<PointResult> points; ///< the 18 named points
    WaveEnergy energy;
    double modal_mass = 0.; ///< kg
    double gap_below  = 0.; ///< relative distance of the next slower mode of the same nodal
                            ///< diameter; 0: none computed
    double gap_above = 0.;  ///< the same for the next faster one

    /** A number that the wave's shape gives. */
    struct ShapeNumber
    {
      std::string name, unit;
      Estimate estimate;
    };
    std::vector<ShapeNumber> shape;
  };

  constexpr unsigned int modes_format_version = 4;

  /** `frequencies.csv`: all modes with their error bars and their content. */
  void write_frequencies(const std::string &path, const std::vector<FoundMode> &modes);

  /** `ellipses.csv`: the elliptic motion of the named points in the travelling wave. */
  void write_ellipses(const std::string &path, const WaveResult &wave);

  /** One of the numbers that tell one stator from another. */
  struct StatorEntry
  {
    std::string group, attribute; ///< where it stands in `modes.h5`
    std::string entry;            ///< of the parameter file
    double value;
  };

  std::vector<StatorEntry> stator_fingerprint(const Parameters &parameters);

  /** `modes.h5`: everything `contact` needs of the wave, and the list of modes. See doc/files.md.
   */
  void write_modes_h5(const std::string &path, const Parameters &parameters,
                      const CyclicSector &sector, const std::vector<FoundMode> &modes,
                      const WaveResult *wave);

  /** One setting of a study: what it costs and how accurate it is. */
  struct StudyRow
  {
    unsigned int degree, refinement; ///< Accuracy/Polynomial degree and Accuracy/Refinement
    unsigned int n_dofs;
    double seconds;       ///< wall clock
    Estimate frequency;   ///< of the motor's wave or, without it, of the first mode; Hz
    double largest_error; ///< relative error bar, the largest of all modes
  };

  /**
   * Writes a study as CSV, with the relative distance of each frequency from that of the row with
   * the smallest error bar.
   */
  void write_study(const std::string &path, const std::vector<StudyRow> &rows);
} // namespace ringmotor
