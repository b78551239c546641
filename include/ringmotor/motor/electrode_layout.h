// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/electrodes.h>
#include <ringmotor/parameters/motor.h>

#include <array>
#include <complex>
#include <string>
#include <vector>

namespace ringmotor
{
  struct Parameters;

  enum class Phase
  {
    a,
    b
  };

  /** Both. */
  inline constexpr std::array<Phase, 2> both_phases{{Phase::a, Phase::b}};

  /** `A` or `B`. */
  inline std::string name_of(const Phase phase)
  {
    return phase == Phase::a ? "A" : "B";
  }

  /** m, of a stator's dimensions, section or mesh. @throws UserError if there is no ceramic, or for
   * an unsuitable file */
  double mean_radius_of_ceramic(const Parameters &parameters);

  /**
   * The arcs of both phases. An arc that is poled down acts like one poled up at the opposite
   * voltage: with one volt on phase A the ceramic, poled up throughout, has a potential of +1 V and
   * -1 V in turn on the arcs of A and 0 elsewhere. In the gaps between arcs the potential is taken
   * to change linearly.
   */
  class ElectrodeLayout
  {
  public:
    /** @param radius m, the mean one of the ceramic, where gaps are measured
     * @throws UserError if the arcs do not fit on the ring */
    ElectrodeLayout(const Electrodes &electrodes, const Motor &motor, const double radius);

    struct Arc
    {
      double begin, end; ///< rad, of the metal
      double sign;       ///< of the poling
    };
    const std::vector<Arc> &arcs(const Phase phase) const
    {
      return arcs_of[static_cast<unsigned int>(phase)];
    }

    /** The part of the ring that the arcs of a phase cover. */
    double coverage(const Phase phase) const;

    /** The coefficient V_k of the potential sum over all k of V_k exp(i k theta) with one volt on a
     * phase. */
    std::complex<double> harmonic(const Phase phase, const int k) const;

    /** How strongly one volt on a phase drives the nodal diameter @p n: the amplitude of the wave
     * of the potential with n waves around the ring, in V; for n = 0 its mean. */
    double excitation(const Phase phase, const unsigned int n) const
    {
      return (n == 0 ? 1. : 2.) * std::abs(harmonic(phase, static_cast<int>(n)));
    }

    /** The part of a standing wave that equal voltages a quarter of a period apart drive, from 0 to
     * 1, for @p n waves: the cosine of the angle between the phases. */
    double standing_part(const unsigned int n) const;

    /** The mean over the ring of the square of that potential: the sum of |V_k|^2. */
    double mean_square(const Phase phase) const;

  private:
    struct Corner
    {
      double angle, potential;
    };

    /** The potential as a broken line. */
    std::vector<Corner> corners(const Phase phase) const;

    std::array<std::vector<Arc>, 2> arcs_of;
    double gap; ///< rad
  };
} // namespace ringmotor
