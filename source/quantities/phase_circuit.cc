// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/quantities/energy.h>
#include <ringmotor/quantities/phase_circuit.h>
#include <ringmotor/structure/motion_products.h>
#include <ringmotor/structure/rigid_motions.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** Nodal diameters n and N - n are conjugate to each other: one stands for both. */
    double weight(const unsigned int n, const unsigned int n_sectors)
    {
      return n == 0 || 2 * n == n_sectors ? 1. : 2.;
    }
  } // namespace

  PhaseCapacitances::PhaseCapacitances(const CyclicSector &sector, const ElectrodeLayout &layout)
      : sector(sector), response(sector), factors(sector)
  {
    const int n_sectors = static_cast<int>(sector.sector_mesh().n_sectors), last = 2 * n_sectors;
    for (const Phase phase : {Phase::a, Phase::b})
      mean_square[index(phase)] = layout.mean_square(phase);
    for (int k = -last; k <= last; ++k)
    {
      const int n = ((k % n_sectors) + n_sectors) % n_sectors;
      if (2 * n > n_sectors)
        continue;
      Harmonic harmonic{k, {}};
      for (const Phase phase : {Phase::a, Phase::b})
      {
        const unsigned int i  = index(phase);
        harmonic.potential[i] = std::conj(layout.harmonic(phase, k));
        resolved[i] += weight(n, n_sectors) * std::norm(harmonic.potential[i]) / mean_square[i];
      }
      harmonics[n].push_back(harmonic);
    }
  }

  PhaseMatrix PhaseCapacitances::at(const double shift)
  {
    const int n_sectors = static_cast<int>(sector.sector_mesh().n_sectors);
    PhaseMatrix sum{};
    double n_last = 0., charge_of_last = 0.;
    for (const auto &[n, of_diameter] : harmonics)
    {
      std::vector<int> numbers;
      for (const Harmonic &harmonic : of_diameter)
        numbers.push_back(harmonic.k);
      const auto matrix = response.capacitances(factors, n, shift, numbers);
      for (unsigned int l = 0; l < numbers.size(); ++l)
        for (unsigned int k = 0; k < numbers.size(); ++k)
          for (const unsigned int row : {0u, 1u})
            for (const unsigned int column : {0u, 1u})
              sum[row][column] +=
                  weight(n, n_sectors) * (std::conj(of_diameter[l].potential[row]) * matrix(l, k) *
                                          of_diameter[k].potential[column])
                                             .real();
      for (unsigned int k = 0; k < numbers.size(); ++k)
        if (2 * std::abs(numbers[k]) > 3 * n_sectors)
        {
          n_last += 1.;
          charge_of_last += matrix(k, k).real();
        }
    }
    for (const unsigned int i : {0u, 1u})
      sum[i][i] += (1. - resolved[i]) * mean_square[i] * charge_of_last / n_last;
    return sum;
  }

  PhaseMatrix PhaseCapacitances::free()
  {
    return at(-slow_eigenvalue(sector)); // below zero, where rigid motions are not singular
  }

  PhaseMatrix PhaseCapacitances::clamped()
  {
    constexpr double fast = 1e20; // inertia resists so much that nothing moves
    return at(-fast * slow_eigenvalue(sector));
  }

  std::complex<double> PhaseCapacitances::charge(const Mode &mode, const Phase phase) const
  {
    Complex sum = 0.;
    for (const Harmonic &harmonic : harmonics.at(mode.nodal_diameter))
      sum += std::conj(harmonic.potential[index(phase)]) * response.charge(mode.motion, harmonic.k);
    return sum;
  }

  std::array<PhaseCircuit, 2> phase_circuits(PhaseCapacitances &capacitances,
                                             const CyclicSector &sector, const Mode &wave,
                                             const double amplitude, const double quality)
  {
    const double mass      = modal_mass(wave_energy(sector, wave), wave, amplitude),
                 square    = wave.eigenvalue;
    const PhaseMatrix free = capacitances.free(), clamped = capacitances.clamped();
    std::array<PhaseCircuit, 2> circuits;
    double highest = 0.; // of the open-circuit frequencies, over the square of the frequency
    for (const Phase phase : {Phase::a, Phase::b})
    {
      const unsigned int i            = static_cast<unsigned int>(phase);
      PhaseCircuit &circuit           = circuits[i];
      circuit.quality                 = quality;
      circuit.short_circuit_frequency = wave.frequency();
      circuit.force_factor            = std::abs(capacitances.charge(wave, phase)) / amplitude;
      circuit.inductance              = mass / std::pow(circuit.force_factor, 2);
      circuit.capacitance             = 1. / (square * circuit.inductance);
      circuit.resistance              = std::sqrt(square) * circuit.inductance / quality;
      circuit.free_capacitance        = free[i][i];
      circuit.clamped_capacitance     = clamped[i][i];
      highest                         = std::max(highest, 1. + circuit.capacitance /
                                                                   (circuit.free_capacitance - circuit.capacitance));
    }
    // What the ceramic and other modes give changes slowly with the frequency, unless one of them
    // is near.
    const PhaseMatrix above = capacitances.at(highest * square),
                      below = capacitances.at((2. - highest) * square);
    for (const unsigned int i : {0u, 1u})
    {
      PhaseCircuit &circuit        = circuits[i];
      const double pole            = circuit.capacitance / (highest - 1.);
      circuit.parallel_capacitance = 0.5 * (above[i][i] + below[i][i]);
      circuit.change_of_parallel   = 0.5 * (above[i][i] + pole - (below[i][i] - pole));
      circuit.open_circuit_frequency =
          circuit.short_circuit_frequency *
          std::sqrt(1. + circuit.capacitance / circuit.parallel_capacitance);
    }
    return circuits;
  }

  double PhaseCircuit::coupling_squared() const
  {
    return 1. - std::pow(short_circuit_frequency / open_circuit_frequency, 2);
  }

  std::vector<Quantity> PhaseCircuit::quantities() const
  {
    return {{"short_circuit_frequency", units::hertz, short_circuit_frequency},
            {"open_circuit_frequency", units::hertz, open_circuit_frequency},
            {"k_eff^2", units::one, coupling_squared()},
            {"force_factor", units::force_factor, force_factor},
            {"C0", units::capacitance, parallel_capacitance},
            {"free_capacitance", units::capacitance, free_capacitance},
            {"clamped_capacitance", units::capacitance, clamped_capacitance},
            {"Lm", units::inductance, inductance},
            {"Cm", units::motional_capacitance, capacitance},
            {"Rm", units::resistance, resistance},
            {"Q", units::one, quality}};
  }

  std::complex<double> PhaseCircuit::admittance(const double frequency) const
  {
    const Complex i_omega(0., 2. * numbers::PI * frequency);
    return i_omega * parallel_capacitance +
           1. / (resistance + i_omega * inductance + 1. / (i_omega * capacitance));
  }

  double stator_quality(const CyclicSector &sector, const Mode &wave,
                        const Piezoelectricity &losses)
  {
    const MotionProducts products = motion_products(sector, {&wave.motion}).front();
    double lost = 2. * losses.piezoelectric_loss_factor * products.electric.coupling +
                  losses.dielectric_loss_factor * products.electric.dielectric;
    for (const auto &[material, stiffness] : products.stiffness)
      lost += sector.material_table().at(material).loss_factor * stiffness;
    return products.total_stiffness() / lost;
  }
} // namespace ringmotor
