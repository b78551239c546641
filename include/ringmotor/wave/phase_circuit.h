// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/electrode_layout.h>
#include <ringmotor/structure/electric_response.h>
#include <ringmotor/wave/mode_search.h>

#include <array>
#include <complex>
#include <map>
#include <vector>

namespace ringmotor
{
  /** Something for each Phase. */
  template <typename Type>
  using PerPhase = std::array<Type, 2>;

  /** The potentials of the phases as harmonics around the ring, up to twice the number of sectors,
   * each with the nodal diameter that it moves. */
  class PhaseHarmonics
  {
  public:
    PhaseHarmonics(const ElectrodeLayout &layout, const unsigned int n_sectors);

    struct Harmonic
    {
      int k;
      PerPhase<std::complex<double>> potential; ///< coefficient of exp(-i k theta) for one volt
    };
    /** Those of nodal diameter @p n; those of N - n are conjugate to them. */
    const std::vector<Harmonic> &of_diameter(const unsigned int n) const { return harmonics.at(n); }

    /** The mean square of a phase's potential over the ring, and the part of it in the harmonics
     * that are left out. */
    double mean_square(const Phase phase) const { return square[index(phase)]; }
    double rest(const Phase phase) const { return square[index(phase)] - resolved[index(phase)]; }

    unsigned int n_sectors() const { return sectors; }

    static unsigned int index(const Phase phase) { return static_cast<unsigned int>(phase); }

    /** How often a nodal diameter stands for itself and its conjugate. */
    double weight(const unsigned int n) const { return n == 0 || 2 * n == sectors ? 1. : 2.; }

  private:
    const unsigned int sectors;
    std::map<unsigned int, std::vector<Harmonic>> harmonics; ///< by nodal diameter
    PerPhase<double> square{}, resolved{};
  };

  /**
   * Charge per volt (F) of each phase at the frequency of a shift omega^2 (rad^2/s^2), the other
   * phase grounded, without damping. The harmonics that are left out move nothing; their part is
   * added with the charge per volt of the last ones.
   */
  PerPhase<double> phase_capacitances(const PhaseHarmonics &harmonics, ElectricResponse &response,
                                      const double shift);

  /** The branch of the equivalent circuit (Butterworth and Van Dyke) for one standing wave of the
   * motor, driven by one phase: Lm, Cm and Rm in series. */
  struct MotionalBranch
  {
    double force_factor = 0.; ///< N/V at the outer edge of the tooth tops, also C/m
    double inductance = 0., capacitance = 0., resistance = 0.; ///< Lm (H), Cm (F), Rm (ohm)
    double quality = 0.; ///< Q of the stator alone, see stator_quality()
  };

  /** The branch of each phase.
   *  @param angular_frequency (rad/s) of the mode: its own on this mesh, or a better estimate
   *  @param amplitude (m) of @p wave at the outer edge of the tooth tops
   *  @param quality see stator_quality() */
  PerPhase<MotionalBranch> motional_branches(const PhaseHarmonics &harmonics,
                                             const CyclicSector &sector, const Mode &wave,
                                             const double angular_frequency, const double amplitude,
                                             const double quality);

  /** What lies in parallel to that branch. */
  struct ParallelCapacitance
  {
    double at_resonance = 0.; ///< C0 (F): the ceramic with all other modes, near the wave
    double change       = 0.; ///< F, of C0 from the resonance to the antiresonance
    double free         = 0.; ///< F, of the whole phase at rest, with the wave's mode
    double clamped      = 0.; ///< F, of the ceramic held everywhere
    double rest = 0.; ///< F, twice what they contain for harmonics that are left out: an error
  };

  PerPhase<ParallelCapacitance> parallel_capacitances(const PhaseHarmonics &harmonics,
                                                      ElectricResponse &response, const Mode &wave,
                                                      const PerPhase<MotionalBranch> &branches);

  /** The equivalent circuit of a phase near the motor's wave, the other phase grounded and the
   * rotor not in contact. */
  struct PhaseCircuit
  {
    double short_circuit_frequency = 0.; ///< Hz, of the wave
    MotionalBranch branch;
    ParallelCapacitance parallel;
    double dielectric_loss_factor = 0.;

    double open_circuit_frequency() const; ///< Hz
    /** k_eff^2 = 1 - (f_short/f_open)^2 = Cm/(C0 + Cm) */
    double coupling_squared() const;
    /** Y(f) in S, with C0 (1 - i tan delta). */
    std::complex<double> admittance(const double frequency) const;
  };

  /**
   * Q of a mode by the losses of the materials: stored energy over energy lost per radian. With
   * complex constants c (1 + i eta), e (1 - i tan_e) and eps (1 - i tan_eps), a wave with the
   * energies K, B and D of SolidElement loses eta K - 2 tan_e B + tan_eps D.
   * @param materials with their loss factors eta
   * @throws ComputationError if it gains power
   */
  double stator_quality(const CyclicSector &sector, const Mode &wave,
                        const MaterialTable &materials, const Piezoelectricity &losses);
} // namespace ringmotor
