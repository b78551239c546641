// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/electrode_layout.h>
#include <ringmotor/quantities/mode_search.h>
#include <ringmotor/quantities/quantity.h>
#include <ringmotor/structure/electric_response.h>

#include <array>
#include <complex>
#include <map>
#include <vector>

namespace ringmotor
{
  /** Charge of a phase (first index) per volt on a phase (second index), in F. */
  using PhaseMatrix = std::array<std::array<double, 2>, 2>;

  /**
   * Charges per volt of both phases, without damping: the sum over the harmonics of their
   * potentials around the ring up to twice the number of sectors. The rest of the harmonics moves
   * nothing; it is added with the charge per volt of the last ones.
   */
  class PhaseCapacitances
  {
  public:
    /** @p sector must outlive this object. */
    PhaseCapacitances(const CyclicSector &sector, const ElectrodeLayout &layout);

    /** At the frequency of a shift omega^2 (rad^2/s^2). */
    PhaseMatrix at(const double shift);

    /** Of a body at rest, free to move. */
    PhaseMatrix free();
    /** Of one that is held everywhere, as at infinite frequency. */
    PhaseMatrix clamped();

    /** The charge (C) of a mode on the arcs of a phase, each with the sign of its poling; also the
     * modal force (N m) per volt. */
    std::complex<double> charge(const Mode &mode, const Phase phase) const;

    /** The share of the harmonics that is added in the square of a phase's potential. */
    double rest(const Phase phase) const { return 1. - resolved[index(phase)]; }

  private:
    static unsigned int index(const Phase phase) { return static_cast<unsigned int>(phase); }

    struct Harmonic
    {
      int k;
      std::array<std::complex<double>, 2> potential; ///< coefficient of exp(-i k theta) by phase
    };

    const CyclicSector &sector;
    const ElectricResponse response;
    CyclicFactors factors;
    std::map<unsigned int, std::vector<Harmonic>> harmonics; ///< by nodal diameter
    std::array<double, 2> mean_square{};                     ///< of the potential over the ring
    std::array<double, 2> resolved{};                        ///< the part of it in #harmonics
  };

  /**
   * The equivalent circuit of one phase near the motor's wave, the other phase grounded: a
   * capacitor C0 in parallel with Lm, Cm, Rm in series, which stand for one standing wave
   * (Butterworth and Van Dyke). The rotor is not in contact.
   */
  struct PhaseCircuit
  {
    double short_circuit_frequency = 0., open_circuit_frequency = 0.; ///< Hz
    double force_factor         = 0.; ///< N/V at the outer edge of the tooth tops, per wave
    double parallel_capacitance = 0.; ///< C0, F
    double change_of_parallel   = 0.; ///< F, from the middle to the open-circuit frequency
    double free_capacitance = 0., clamped_capacitance = 0.;    ///< F, at rest and at high frequency
    double inductance = 0., capacitance = 0., resistance = 0.; ///< Lm (H), Cm (F), Rm (ohm)
    double quality = 0.; ///< Q of the stator: losses in its materials only

    /** k_eff^2 = 1 - (f_short/f_open)^2 */
    double coupling_squared() const;

    /** For all outputs. */
    std::vector<Quantity> quantities() const;

    /** Y(f) in S, without the losses of C0. */
    std::complex<double> admittance(const double frequency) const;
  };

  /** The circuits of both phases.
   *  @param amplitude (m) of @p wave at the outer edge of the tooth tops
   *  @param quality see stator_quality() */
  std::array<PhaseCircuit, 2> phase_circuits(PhaseCapacitances &capacitances,
                                             const CyclicSector &sector, const Mode &wave,
                                             const double amplitude, const double quality);

  /** Q of a mode by the losses of the materials: stored energy over energy lost per radian. With
   * complex constants, c (1 + i eta), e (1 - i tan_e) and eps (1 - i tan_eps), a wave of which the
   * energies are K, B and D (see SolidElement) loses eta K + 2 tan_e B + tan_eps D. */
  double stator_quality(const CyclicSector &sector, const Mode &wave,
                        const Piezoelectricity &losses);
} // namespace ringmotor
