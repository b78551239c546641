// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/motion_products.h>
#include <ringmotor/structure/rigid_motions.h>
#include <ringmotor/wave/energy.h>
#include <ringmotor/wave/phase_circuit.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;
  } // namespace

  PhaseHarmonics::PhaseHarmonics(const ElectrodeLayout &layout, const unsigned int n_sectors)
      : sectors(n_sectors)
  {
    for (const Phase phase : both_phases)
      square[index(phase)] = layout.mean_square(phase);
    const int period = static_cast<int>(n_sectors), last = 2 * period;
    for (int k = -last; k <= last; ++k)
    {
      const int n = ((k % period) + period) % period;
      if (2 * n > period)
        continue;
      Harmonic harmonic{k, {}};
      for (const Phase phase : both_phases)
      {
        harmonic.potential[index(phase)] = std::conj(layout.harmonic(phase, k));
        resolved[index(phase)] += weight(n) * std::norm(harmonic.potential[index(phase)]);
      }
      harmonics[n].push_back(harmonic);
    }
  }

  PerPhase<double> phase_capacitances(const PhaseHarmonics &harmonics, ElectricResponse &response,
                                      const double shift)
  {
    response.condense(shift);
    PerPhase<double> sum{};
    double n_last = 0., charge_of_last = 0.;
    for (unsigned int n = 0; 2 * n <= harmonics.n_sectors(); ++n)
    {
      const std::vector<PhaseHarmonics::Harmonic> &of_diameter = harmonics.of_diameter(n);
      std::vector<int> numbers;
      for (const PhaseHarmonics::Harmonic &harmonic : of_diameter)
        numbers.push_back(harmonic.k);
      const auto matrix = response.capacitances(n, numbers);
      for (unsigned int l = 0; l < numbers.size(); ++l)
        for (unsigned int k = 0; k < numbers.size(); ++k)
          for (unsigned int i = 0; i < sum.size(); ++i)
            sum[i] += harmonics.weight(n) * (std::conj(of_diameter[l].potential[i]) * matrix(l, k) *
                                             of_diameter[k].potential[i])
                                                .real();
      for (unsigned int k = 0; k < numbers.size(); ++k)
        if (2 * std::abs(numbers[k]) > 3 * static_cast<int>(harmonics.n_sectors()))
        {
          n_last += 1.;
          charge_of_last += matrix(k, k).real();
        }
    }
    for (const Phase phase : both_phases)
      sum[PhaseHarmonics::index(phase)] += harmonics.rest(phase) * charge_of_last / n_last;
    return sum;
  }

  PerPhase<MotionalBranch> motional_branches(const PhaseHarmonics &harmonics,
                                             const CyclicSector &sector, const Mode &wave,
                                             const double angular_frequency, const double amplitude,
                                             const double quality)
  {
    const auto &of_wave = harmonics.of_diameter(wave.nodal_diameter);
    std::vector<int> numbers;
    for (const PhaseHarmonics::Harmonic &harmonic : of_wave)
      numbers.push_back(harmonic.k);
    const std::vector<Complex> of_mode = electrode_charges(sector, wave.motion, numbers);
    PerPhase<Complex> charges{}; // on the arcs of a phase, each with the sign of its poling
    for (unsigned int k = 0; k < of_wave.size(); ++k)
      for (unsigned int i = 0; i < charges.size(); ++i)
        charges[i] += std::conj(of_wave[k].potential[i]) * of_mode[k];
    const double mass = modal_mass(wave_energy(sector, wave), wave, amplitude);
    PerPhase<MotionalBranch> branches;
    for (unsigned int i = 0; i < branches.size(); ++i)
    {
      MotionalBranch &branch = branches[i];
      branch.force_factor    = std::abs(charges[i]) / amplitude;
      branch.inductance      = mass / std::pow(branch.force_factor, 2);
      branch.capacitance     = 1. / (angular_frequency * angular_frequency * branch.inductance);
      branch.quality         = quality;
      branch.resistance      = angular_frequency * branch.inductance / branch.quality;
    }
    return branches;
  }

  PerPhase<ParallelCapacitance> parallel_capacitances(const PhaseHarmonics &harmonics,
                                                      ElectricResponse &response, const Mode &wave,
                                                      const PerPhase<MotionalBranch> &branches)
  {
    const auto at = [&](const double shift)
    { return phase_capacitances(harmonics, response, shift); };
    const double slow = slow_eigenvalue(response.body());
    // Below zero, where rigid motions are not singular; where inertia resists so much that nothing
    // moves; and about as far beside the resonance as the antiresonance.
    constexpr double fast       = 1e20;
    const PerPhase<double> free = at(-slow), clamped = at(-fast * slow);
    double distance = 1e-4; // with less, rounding errors of a weak coupling would show
    for (unsigned int i = 0; i < free.size(); ++i)
      distance = std::max(distance, branches[i].capacitance / (free[i] - branches[i].capacitance));
    const PerPhase<double> below = at((1. - distance) * wave.eigenvalue),
                           above = at((1. + distance) * wave.eigenvalue);
    PerPhase<ParallelCapacitance> results;
    for (const Phase phase : both_phases)
    {
      const unsigned int i    = PhaseHarmonics::index(phase);
      const double of_mode    = branches[i].capacitance / distance; // of either sign
      results[i].at_resonance = 0.5 * (below[i] + above[i]);
      results[i].change       = 0.5 * (above[i] + of_mode - (below[i] - of_mode));
      results[i].free         = free[i];
      results[i].clamped      = clamped[i];
      results[i].rest = 2. * harmonics.rest(phase) / harmonics.mean_square(phase) * clamped[i];
    }
    return results;
  }

  double PhaseCircuit::open_circuit_frequency() const
  {
    return short_circuit_frequency * std::sqrt(1. + branch.capacitance / parallel.at_resonance);
  }

  double PhaseCircuit::coupling_squared() const
  {
    return branch.capacitance / (branch.capacitance + parallel.at_resonance);
  }

  std::complex<double> PhaseCircuit::admittance(const double frequency) const
  {
    const Complex i_omega(0., 2. * numbers::PI * frequency);
    return i_omega * Complex(1., -dielectric_loss_factor) * parallel.at_resonance +
           1. / (branch.resistance + i_omega * branch.inductance +
                 1. / (i_omega * branch.capacitance));
  }

  double stator_quality(const CyclicSector &sector, const Mode &wave,
                        const MaterialTable &materials, const Piezoelectricity &losses)
  {
    const MotionProducts products = motion_products(sector, {&wave.motion}).front();
    double lost                   = losses.dielectric_loss_factor * products.electric.dielectric -
                  2. * losses.piezoelectric_loss_factor * products.electric.coupling;
    for (const auto &[material, stiffness] : products.stiffness)
      lost += materials.at(material).loss_factor * stiffness;
    if (lost <= 0.)
      throw ComputationError(
          "the wave would gain power from Piezoelectricity/Piezoelectric loss factor; choose a "
          "smaller one, or larger loss factors of ceramic and metal");
    return products.total_stiffness() / lost;
  }
} // namespace ringmotor
